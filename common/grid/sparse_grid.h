#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/grid/cell_corners.h"
#include "common/grid/morton.h"

namespace burnish {

/// Returns the offset of local corner a of a cell, (a & 1, (a >> 1) & 1, a >> 2): x fastest.
inline Vec3i corner_offset(int a) {
  return {a & 1, (a >> 1) & 1, a >> 2};
}

inline constexpr int32_t kNone = -1;

/// Identifies a cell or corner of one depth. Separate pieces of surface get separate coarse cells
/// and corners even in the same place. Otherwise every coarse correction of a piece would drag a
/// small floating piece beside it along.
struct GridKey {
  MortonKey place;
  int32_t component;
  auto operator<=>(const GridKey&) const = default;
};

/// The cells of one depth that the surface meets, and their corners: the unknowns. Cells and
/// corners are in Morton order, then by component. Cell (i, j, k) spans [i, i+1] × [j, j+1] × [k,
/// k+1] in grid units of this depth. At the finest depth each place has one cell.
struct SparseGrid {
  int depth = 0;
  std::vector<GridKey> cells;                                      ///< strictly rising
  std::vector<GridKey> corners;                                    ///< strictly rising
  std::vector<std::array<int32_t, kCornersPerCell>> cell_corners;  ///< corner indices of a cell
  /// The cells around a corner, kNone if inactive: cells_of_corner[I][a] is the cell in which
  /// corner I is local corner a.
  std::vector<std::array<int32_t, kCornersPerCell>> cells_of_corner;

  int32_t cell_count() const { return static_cast<int32_t>(cells.size()); }
  int32_t corner_count() const { return static_cast<int32_t>(corners.size()); }

  /// Returns the index of a cell of the finest depth by its coordinates; kNone if inactive or
  /// outside. O(log cells).
  int32_t find_cell(const Vec3i& cell) const;
};

/// Leaves every corner without cells. Needs: the corners.
void clear_cells_of_corners(SparseGrid& grid);

/// Returns keys of the finest cells before their components are known.
std::vector<GridKey> finest_keys(std::span<const MortonKey> cells);

/// Makes the finest depth and finds its components: two cells are connected if they share a corner.
/// Needs: `cells` strictly rising, inside the grid of that depth.
SparseGrid make_finest_grid(int depth, std::span<const MortonKey> cells);

/// Makes the depth above `fine`: the parents of its cells.
SparseGrid make_parent_grid(const SparseGrid& fine);

/// Returns the key of a cell's parent.
inline GridKey parent_key(const GridKey& cell) {
  return {cell.place >> 3, cell.component};
}

/// Returns the index of `key` among strictly rising keys, kNone if absent. O(log n).
int32_t find_key(std::span<const GridKey> sorted, const GridKey& key);

}  // namespace burnish
