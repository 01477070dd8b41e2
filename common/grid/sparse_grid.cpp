#include "common/grid/sparse_grid.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "common/base/parallel.h"

namespace burnish {

namespace {

GridKey corner_key(const GridKey& cell, int a) {
  return {morton_key(morton_point(cell.place) + corner_offset(a)), cell.component};
}

void sort_unique(std::vector<GridKey>& keys) {
  parallel_sort(keys.begin(), keys.end(), std::less<>());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  keys.shrink_to_fit();
}

std::vector<GridKey> all_corners(std::span<const GridKey> cells) {
  std::vector<GridKey> corners;
  corners.reserve(cells.size() * kCornersPerCell);
  for (const GridKey& cell : cells)
    for (int a = 0; a < kCornersPerCell; ++a) corners.push_back(corner_key(cell, a));
  sort_unique(corners);
  return corners;
}

SparseGrid connect(int depth, std::vector<GridKey> cells) {
  SparseGrid grid;
  grid.depth = depth;
  grid.cells = std::move(cells);
  grid.corners = all_corners(grid.cells);
  grid.cell_corners.resize(grid.cells.size());
  grid.cells_of_corner.resize(grid.corners.size());
  for (auto& around : grid.cells_of_corner) around.fill(kNone);
#pragma omp parallel for schedule(static)
  for (int32_t c = 0; c < grid.cell_count(); ++c) {
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t corner = find_key(grid.corners, corner_key(grid.cells[c], a));
      grid.cell_corners[c][a] = corner;
      grid.cells_of_corner[corner][a] = c;  // one writer for each (corner, a)
    }
  }
  return grid;
}

// Union-find over the cells around each corner. Returns the root of every cell.
std::vector<int32_t> component_roots(const SparseGrid& grid) {
  std::vector<int32_t> root(grid.cells.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int32_t cell) {
    while (root[cell] != cell) cell = root[cell] = root[root[cell]];
    return cell;
  };
  for (const auto& around : grid.cells_of_corner) {
    int32_t first = kNone;
    for (int32_t cell : around) {
      if (cell == kNone) continue;
      if (first == kNone) first = find(cell);
      root[find(cell)] = first;
    }
  }
  for (int32_t cell = 0; cell < grid.cell_count(); ++cell) root[cell] = find(cell);
  return root;
}

void mark_components(SparseGrid& grid) {
  const std::vector<int32_t> root = component_roots(grid);
  for (int32_t cell = 0; cell < grid.cell_count(); ++cell) {
    grid.cells[cell].component = root[cell];
    for (int32_t corner : grid.cell_corners[cell]) grid.corners[corner].component = root[cell];
  }
}

}  // namespace

int32_t find_key(std::span<const GridKey> sorted, const GridKey& key) {
  const auto it = std::lower_bound(sorted.begin(), sorted.end(), key);
  if (it == sorted.end() || *it != key) return kNone;
  return static_cast<int32_t>(it - sorted.begin());
}

int32_t SparseGrid::find_cell(const Vec3i& cell) const {
  const int side = 1 << depth;
  if ((cell.array() < 0).any() || (cell.array() >= side).any()) return kNone;
  const MortonKey place = morton_key(cell);
  const auto it = std::lower_bound(cells.begin(), cells.end(), GridKey{place, 0});
  if (it == cells.end() || it->place != place) return kNone;
  return static_cast<int32_t>(it - cells.begin());
}

std::vector<GridKey> finest_keys(std::span<const MortonKey> cells) {
  std::vector<GridKey> keys(cells.size());
  for (size_t c = 0; c < cells.size(); ++c) keys[c] = {cells[c], 0};
  return keys;
}

SparseGrid make_finest_grid(int depth, std::span<const MortonKey> cells) {
  SparseGrid grid = connect(depth, finest_keys(cells));
  mark_components(grid);
  return grid;
}

SparseGrid make_parent_grid(const SparseGrid& fine) {
  std::vector<GridKey> parents(fine.cells.size());
  for (size_t c = 0; c < parents.size(); ++c) parents[c] = parent_key(fine.cells[c]);
  sort_unique(parents);
  return connect(fine.depth - 1, std::move(parents));
}

}  // namespace burnish
