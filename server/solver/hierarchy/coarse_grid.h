#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// A corner in coarse cell `cell`, at position `place` of its 3×3×3 half-way points.
struct FromCell {
  int32_t cell;
  uint8_t place;
};

/// The depth above some cells, and how these cells hang on it.
struct CoarseGrid {
  SparseGrid grid;
  std::vector<int32_t> parent_cell;  ///< one per fine cell
  std::vector<FromCell> from;        ///< one per fine corner
};

/// Makes one cell for all cells of a piece of surface in one place, and one corner likewise.
CoarseGrid join_sheets(const SparseGrid& fine);

/// Makes one cell for those cells of a place that hang together by corners. Makes one corner where
/// coarse cells hang together by fine corners that it weighs on. A corner with cells of several
/// sheets on one side has no cells_of_corner. Shapes: cells in the order of their places, their
/// corners below `corner_count`.
CoarseGrid keep_sheets_apart(int depth, std::span<const GridKey> cells,
                             std::span<const std::array<int32_t, kCornersPerCell>> cell_corners,
                             int32_t corner_count);

}  // namespace burnish
