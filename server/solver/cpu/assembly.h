#pragma once

#include <span>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Combined integrals of the finest depth. Units: α in user units × alpha_scale = grid units.
void combine_integrals(const PreparedMesh& prepared, std::span<const float> alpha1,
                       std::span<const float> alpha2, CpuDepth& finest);

/// Combined integrals of `coarse` from those of the depth below: Σ over children of Pᵀ K P.
void down_sample(const CpuDepth& fine, CpuDepth& coarse);

/// The depth's matrix and inverse diagonal from its cells. Source: section 5.2.
void assemble(CpuDepth& depth);

/// Sums per-cell matrices into rows of the stencil: row(corner, entries by slot, sum of own).
/// `pair_of(cell)` and `own_of(cell)` give a cell's packed pairs and its eight own numbers.
template <typename PairOf, typename OwnOf, typename Row>
void gather_rows(const HierarchyDepth& topology, PairOf&& pair_of, OwnOf&& own_of, Row&& row) {
  const int32_t n = topology.grid.corner_count();
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < n; ++corner) {
    double by_slot[kSlots] = {};
    double own = 0;
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t cell = topology.grid.cells_of_corner[corner][a];
      if (cell == kNone) continue;
      const auto& pair = pair_of(cell);
      own += own_of(cell)[a];
      for (int b = 0; b < kCornersPerCell; ++b)
        if (b != a) by_slot[slot_between(a, b)] += pair[pair_index(a, b)];
    }
    row(corner, by_slot, own);
  }
}

/// Writes the present slots of a row into `entry`, times scale(column).
template <typename Scale>
void store_row(const Stencil& stencil, int32_t corner, const double* by_slot,
               std::vector<float>& entry, Scale&& scale) {
  int64_t k = stencil.row_start[corner];
  for (uint32_t left = stencil.mask[corner]; left != 0; left &= left - 1, ++k)
    entry[k] = static_cast<float>(by_slot[__builtin_ctz(left)] * scale(stencil.column[k]));
}

}  // namespace burnish::cpu
