#pragma once

#include "common/base/dispatch.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cpu {

/// Σ Pᵀ K P over the children of one coarse cell: all rows, and their sums.
struct RestrictedCell {
  Double8 row[8] = {};
  Double8 row_sum = {};

  CellMatrix packed() const;
};

/// sum += Pᵀ K P for the child in `octant` (bit i: the high side of axis i) of its parent.
void add_restricted(const CellMatrix& child, int octant, RestrictedCell& sum);

}  // namespace burnish::cpu
