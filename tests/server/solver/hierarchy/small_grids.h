#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <vector>

#include "common/grid/sparse_grid.h"

namespace burnish {

using CellCorners = std::array<int32_t, kCornersPerCell>;

/// Returns the corners of a cell that shares none: first, first + 1, ...
inline CellCorners corners_from(int32_t first) {
  CellCorners corners;
  std::iota(corners.begin(), corners.end(), first);
  return corners;
}

/// Returns the key of a fine cell; no test here reads its component.
inline GridKey cell_at(int x, int y, int z) {
  return {morton_key({x, y, z}), 0};
}

/// Returns the finest depth with these cells. Needs: cells in Morton order.
inline SparseGrid grid_of(int depth, std::initializer_list<Vec3i> cells) {
  std::vector<MortonKey> keys;
  for (const Vec3i& cell : cells) keys.push_back(morton_key(cell));
  return make_finest_grid(depth, keys);
}

/// Returns cells A = (0, 0, 0) and B = (1, 0, 0), which share the face x = 1.
///
/// Corners are in Morton order. Corner (x, y, z) with x < 2 is x + 2y + 4z: A has 0 to 7 in its own
/// order. The corners at x = 2 follow as 8 to 11. So B has 1, 8, 3, 9, 5, 10, 7 and 11.
inline SparseGrid two_cells_with_a_common_face() {
  return grid_of(2, {{0, 0, 0}, {1, 0, 0}});
}

/// Returns cells A = (0, 0, 0) and D = (1, 1, 1), which share the corner (1, 1, 1): 7 of A, 0 of D.
///
/// A's corners are 0 to 7 as above. D's rise in its own order: 7, then 8 to 14.
inline SparseGrid two_cells_with_a_common_corner() {
  return grid_of(2, {{0, 0, 0}, {1, 1, 1}});
}

}  // namespace burnish
