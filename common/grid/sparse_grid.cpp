#include "common/grid/sparse_grid.h"

#include <algorithm>
#include <functional>

#include "common/base/disjoint_sets.h"
#include "common/base/parallel.h"
#include "common/base/resize_touched.h"
#include "common/grid/corner_bricks.h"

namespace burnish {

namespace {

void sort_unique(std::vector<GridKey>& keys) {
  parallel_sort(keys.begin(), keys.end(), std::less<>());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  keys.shrink_to_fit();
}

SparseGrid connect(int depth, std::vector<GridKey> cells) {
  SparseGrid grid;
  grid.depth = depth;
  grid.cells = std::move(cells);
  const CornerBricks bricks(grid.cells);
  grid.corners = bricks.corners();
  resize_touched(grid.cell_corners, grid.cells.size());
  clear_cells_of_corners(grid);
  const std::span<const CornerBricks::Run> runs = bricks.runs();
#pragma omp parallel for schedule(static)
  for (size_t run = 0; run < runs.size(); ++run) {
    bricks.number(runs[run], grid.cells.data(), grid.cell_corners.data());
    for (int32_t c = runs[run].first; c < runs[run].last; ++c)
      for (int a = 0; a < kCornersPerCell; ++a)  // one writer for each (corner, a)
        grid.cells_of_corner[grid.cell_corners[c][a]][a] = c;
  }
  return grid;
}

// Unites cells that share a corner. Returns the least cell of each cell's component.
std::vector<int32_t> component_roots(const SparseGrid& grid) {
  DisjointSets sets(grid.cells.size());
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner) {
    int32_t first = kNone;
    for (const int32_t cell : grid.cells_of_corner[corner]) {
      if (cell == kNone) continue;
      if (first == kNone) first = cell;
      sets.join(first, cell);
    }
  }
  std::vector<int32_t> root(grid.cells.size());
#pragma omp parallel for schedule(static)
  for (int32_t cell = 0; cell < grid.cell_count(); ++cell) root[cell] = sets.root(cell);
  return root;
}

void mark_components(SparseGrid& grid) {
  const std::vector<int32_t> root = component_roots(grid);
#pragma omp parallel for schedule(static)
  for (int32_t cell = 0; cell < grid.cell_count(); ++cell) grid.cells[cell].component = root[cell];
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner) {
    const auto& around = grid.cells_of_corner[corner];
    grid.corners[corner].component = root[*std::ranges::max_element(around)];
  }
}

}  // namespace

void clear_cells_of_corners(SparseGrid& grid) {
  grid.cells_of_corner.clear();
  resize_touched(grid.cells_of_corner, grid.corners.size());
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner)
    grid.cells_of_corner[corner].fill(kNone);
}

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
  std::vector<GridKey> keys;
  resize_touched(keys, cells.size());
#pragma omp parallel for schedule(static)
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
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < parents.size(); ++c) parents[c] = parent_key(fine.cells[c]);
  sort_unique(parents);
  return connect(fine.depth - 1, std::move(parents));
}

}  // namespace burnish
