#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/grid/morton.h"

namespace burnish {

/// Local corner a of a cell sits at offset (a & 1, (a >> 1) & 1, a >> 2): x fastest.
inline constexpr int kCornersPerCell = 8;
inline Vec3i corner_offset(int a) { return {a & 1, (a >> 1) & 1, a >> 2}; }

inline constexpr int32_t kNone = -1;

/// The cells of one depth that the surface meets, and their corners: the unknowns.
/// Cells and corners are each in Morton order. Cell (i, j, k) spans [i, i+1] × [j, j+1] × [k, k+1]
/// in grid units of this depth.
struct SparseGrid {
  int depth = 0;
  std::vector<MortonKey> cells;                                    ///< strictly rising
  std::vector<MortonKey> corners;                                  ///< strictly rising
  std::vector<std::array<int32_t, kCornersPerCell>> cell_corners;  ///< corner indices of a cell
  /// The cell on each side of a corner, kNone where inactive: cells_of_corner[I][a] is the cell in
  /// which corner I is local corner a.
  std::vector<std::array<int32_t, kCornersPerCell>> cells_of_corner;

  int32_t cell_count() const { return static_cast<int32_t>(cells.size()); }
  int32_t corner_count() const { return static_cast<int32_t>(corners.size()); }

  /// Index of a cell by its coordinates, kNone if inactive or outside. O(log cells).
  int32_t find_cell(const Vec3i& cell) const;
};

/// Needs: `cells` strictly rising, inside the grid of that depth.
SparseGrid make_sparse_grid(int depth, std::span<const MortonKey> cells);

/// The parents' keys, each once, of strictly rising `cells`.
std::vector<MortonKey> parent_cells(std::span<const MortonKey> cells);

}  // namespace burnish
