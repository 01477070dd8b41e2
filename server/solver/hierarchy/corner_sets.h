#pragma once

#include <cstdint>
#include <span>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// Calls visit(cell) for every cell at each of these corners, perhaps more than once.
template <typename Visit>
void for_each_cell_around(const SparseGrid& grid, std::span<const int32_t> corners, Visit&& visit) {
  for (const int32_t corner : corners)
    for (const int32_t cell : grid.cells_of_corner[corner])
      if (cell != kNone) visit(cell);
}

}  // namespace burnish
