#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/grid/cell_corners.h"
#include "common/grid/morton.h"

namespace burnish {

/// Local corner a of a cell sits at offset (a & 1, (a >> 1) & 1, a >> 2): x fastest.
inline Vec3i corner_offset(int a) {
  return {a & 1, (a >> 1) & 1, a >> 2};
}

inline constexpr int32_t kNone = -1;

/// What tells a cell or corner from the others of its depth. Separate pieces of surface get
/// separate coarse cells and corners even where they pass through the same place: a small floating
/// piece would else be dragged along by every coarse correction of its neighbour.
struct GridKey {
  MortonKey place;
  int32_t component;
  auto operator<=>(const GridKey&) const = default;
};

/// The cells of one depth that the surface meets, and their corners: the unknowns.
/// Cells and corners are each in Morton order, then by component. Cell (i, j, k) spans
/// [i, i+1] × [j, j+1] × [k, k+1] in grid units of this depth. At the finest depth places are
/// unique.
struct SparseGrid {
  int depth = 0;
  std::vector<GridKey> cells;                                      ///< strictly rising
  std::vector<GridKey> corners;                                    ///< strictly rising
  std::vector<std::array<int32_t, kCornersPerCell>> cell_corners;  ///< corner indices of a cell
  /// The cell on each side of a corner, kNone where inactive: cells_of_corner[I][a] is the cell in
  /// which corner I is local corner a.
  std::vector<std::array<int32_t, kCornersPerCell>> cells_of_corner;

  int32_t cell_count() const { return static_cast<int32_t>(cells.size()); }
  int32_t corner_count() const { return static_cast<int32_t>(corners.size()); }

  /// Index of a cell of the finest depth by its coordinates, kNone if inactive or outside.
  /// O(log cells).
  int32_t find_cell(const Vec3i& cell) const;
};

/// Cells of the finest depth before anything is known of components.
std::vector<GridKey> finest_keys(std::span<const MortonKey> cells);

/// The finest depth, its components found: two cells are connected when they share a corner.
/// Needs: `cells` strictly rising, inside the grid of that depth.
SparseGrid make_finest_grid(int depth, std::span<const MortonKey> cells);

/// The depth above `fine`: the parents of its cells.
SparseGrid make_parent_grid(const SparseGrid& fine);

/// The key of a cell's parent.
inline GridKey parent_key(const GridKey& cell) {
  return {cell.place >> 3, cell.component};
}

/// Index of `key` among strictly rising keys, kNone if absent. O(log n).
int32_t find_key(std::span<const GridKey> sorted, const GridKey& key);

}  // namespace burnish
