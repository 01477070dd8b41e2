#include "common/grid/sparse_grid.h"

#include <algorithm>
#include <functional>

#include "common/base/check.h"
#include "common/base/parallel.h"

namespace burnish {

template <typename T>
static int32_t find_sorted(std::span<const T> sorted, T key) {
  const auto it = std::lower_bound(sorted.begin(), sorted.end(), key);
  if (it == sorted.end() || *it != key) return kNone;
  return static_cast<int32_t>(it - sorted.begin());
}

static std::vector<MortonKey> all_corners(std::span<const MortonKey> cells) {
  std::vector<MortonKey> corners;
  corners.reserve(cells.size() * kCornersPerCell);
  for (MortonKey cell : cells) {
    const Vec3i least = morton_point(cell);
    for (int a = 0; a < kCornersPerCell; ++a) corners.push_back(morton_key(least + corner_offset(a)));
  }
  parallel_sort(corners.begin(), corners.end(), std::less<>());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  corners.shrink_to_fit();
  return corners;
}

int32_t SparseGrid::find_cell(const Vec3i& cell) const {
  const int side = 1 << depth;
  if ((cell.array() < 0).any() || (cell.array() >= side).any()) return kNone;
  return find_sorted<MortonKey>(cells, morton_key(cell));
}

SparseGrid make_sparse_grid(int depth, std::span<const MortonKey> cells) {
  SparseGrid grid;
  grid.depth = depth;
  grid.cells.assign(cells.begin(), cells.end());
  grid.corners = all_corners(cells);
  grid.cell_corners.resize(cells.size());
  grid.cells_of_corner.resize(grid.corners.size());
  for (auto& around : grid.cells_of_corner) around.fill(kNone);

#pragma omp parallel for schedule(static)
  for (int64_t c = 0; c < static_cast<int64_t>(cells.size()); ++c) {
    const Vec3i least = morton_point(cells[c]);
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t corner =
          find_sorted<MortonKey>(grid.corners, morton_key(least + corner_offset(a)));
      grid.cell_corners[c][a] = corner;
      grid.cells_of_corner[corner][a] = static_cast<int32_t>(c);  // one writer for each (corner, a)
    }
  }
  return grid;
}

std::vector<MortonKey> parent_cells(std::span<const MortonKey> cells) {
  std::vector<MortonKey> parents;
  for (MortonKey cell : cells) {
    if (parents.empty() || parents.back() != cell >> 3) parents.push_back(cell >> 3);
  }
  return parents;
}

}  // namespace burnish
