#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "server/solver/cuda/device/packed.h"
#include "server/solver/hierarchy/stencil.h"

namespace burnish::cuda {

/// Returns the first entries of a row, which go into slices: as many as a slice takes.
inline Stencil::Row packed_part(const Stencil& stencil, int32_t corner) {
  const Stencil::Row row = stencil.row(corner);
  return {row.begin, std::min(row.end, row.begin + kEntriesMax)};
}

/// The further entries of all rows, one row after the other. They are few: slices as long as the
/// longest row would be hundreds of entries wide, and tiles would not hold their columns.
struct LongRowTails {
  std::vector<int32_t> start;  ///< corners + 1; both empty if no row has any
  std::vector<int32_t> column;
};
LongRowTails long_row_tails(const Stencil& stencil);

}  // namespace burnish::cuda
