#include "common/grid/sparse_grid.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace burnish {
namespace {

SparseGrid grid_of(int depth, const std::vector<Vec3i>& cells) {
  std::set<MortonKey> keys;
  for (const Vec3i& cell : cells) keys.insert(morton_key(cell));
  const std::vector<MortonKey> sorted(keys.begin(), keys.end());
  return make_finest_grid(depth, sorted);
}

// Returns scattered cells, among them the outermost cells of the grid.
SparseGrid scattered_grid() {
  std::mt19937 random(3);
  std::vector<Vec3i> cells = {{0, 0, 0}, {31, 31, 31}};
  for (int i = 0; i < 700; ++i) cells.emplace_back(random() % 32, random() % 32, random() % 8);
  return grid_of(5, cells);
}

std::set<int32_t> components_of(const SparseGrid& grid) {
  std::set<int32_t> components;
  for (const GridKey& cell : grid.cells) components.insert(cell.component);
  return components;
}

void expect_consistent(const SparseGrid& grid) {
  EXPECT_TRUE(std::is_sorted(grid.cells.begin(), grid.cells.end(), std::less<>()));
  EXPECT_TRUE(std::is_sorted(grid.corners.begin(), grid.corners.end(), std::less<>()));
  for (int32_t c = 0; c < grid.cell_count(); ++c) {
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t corner = grid.cell_corners[c][a];
      const Vec3i place = morton_point(grid.cells[c].place) + corner_offset(a);
      ASSERT_EQ(morton_point(grid.corners[corner].place), place);
      ASSERT_EQ(grid.corners[corner].component, grid.cells[c].component);
      ASSERT_EQ(grid.cells_of_corner[corner][a], c);
    }
  }
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner) {
    int cells = 0;
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t cell = grid.cells_of_corner[corner][a];
      if (cell == kNone) continue;
      ++cells;
      ASSERT_EQ(grid.cell_corners[cell][a], corner);
    }
    ASSERT_GT(cells, 0) << "corner " << corner << " belongs to no cell";
  }
}

TEST(SparseGrid, CellsAndCornersNameOneAnotherAtEveryDepth) {
  SparseGrid grid = scattered_grid();
  expect_consistent(grid);
  while (grid.depth > 0) {
    grid = make_parent_grid(grid);
    expect_consistent(grid);
  }
}

TEST(SparseGrid, OneCellHasEightCorners) {
  const SparseGrid grid = grid_of(4, {{15, 0, 7}});
  EXPECT_EQ(grid.cell_count(), 1);
  EXPECT_EQ(grid.corner_count(), 8);
}

TEST(SparseGrid, FindsItsCellsAndNoOthers) {
  const SparseGrid grid = scattered_grid();
  for (int32_t c = 0; c < grid.cell_count(); ++c)
    ASSERT_EQ(grid.find_cell(morton_point(grid.cells[c].place)), c);
  int32_t found = 0;
  for (int i = -1; i <= 32; ++i)
    for (int j = -1; j <= 32; ++j)
      for (int k = -1; k <= 32; ++k) found += grid.find_cell({i, j, k}) != kNone;
  EXPECT_EQ(found, grid.cell_count());
}

TEST(GridComponents, AreSeparateWherePiecesShareNoCorner) {
  const SparseGrid grid = grid_of(4, {{2, 2, 2}, {3, 2, 2}, {5, 2, 2}});
  EXPECT_EQ(components_of(grid).size(), 2u);
  EXPECT_EQ(grid.cells[grid.find_cell({2, 2, 2})].component,
            grid.cells[grid.find_cell({3, 2, 2})].component);
}

TEST(GridComponents, AreOneWherePiecesShareASingleCorner) {
  EXPECT_EQ(components_of(grid_of(4, {{2, 2, 2}, {3, 3, 3}})).size(), 1u);
  EXPECT_EQ(components_of(grid_of(4, {{3, 2, 3}, {2, 3, 2}})).size(), 1u);
}

TEST(GridComponents, MergeWhenTheLastCellBridgesThem) {
  std::vector<Vec3i> comb;  // two rows, joined at the far end only
  for (int i = 0; i < 16; ++i) comb.insert(comb.end(), {{i, 0, 0}, {i, 4, 0}});
  EXPECT_EQ(components_of(grid_of(4, comb)).size(), 2u);
  for (int j = 1; j < 4; ++j) comb.emplace_back(15, j, 0);
  EXPECT_EQ(components_of(grid_of(4, comb)).size(), 1u);
}

TEST(ParentGrid, KeepsSeparatePiecesSeparateInTheSamePlace) {
  // Cells 4 and 6 share no corner. Their parents 2 and 3 would share one; at depth 2 both lie in
  // cell 1.
  SparseGrid grid = grid_of(4, {{4, 0, 0}, {6, 0, 0}});
  for (int depth = 3; depth >= 0; --depth) {
    grid = make_parent_grid(grid);
    EXPECT_EQ(grid.depth, depth);
    EXPECT_EQ(grid.cell_count(), 2);
    EXPECT_EQ(grid.corner_count(), 16);
    expect_consistent(grid);
  }
}

TEST(ParentGrid, HoldsExactlyTheParents) {
  const SparseGrid fine = scattered_grid();
  const SparseGrid coarse = make_parent_grid(fine);
  std::set<int32_t> parents;
  for (const GridKey& cell : fine.cells) {
    const int32_t parent = find_key(coarse.cells, parent_key(cell));
    ASSERT_NE(parent, kNone);
    EXPECT_EQ(morton_point(coarse.cells[parent].place), Vec3i(morton_point(cell.place) / 2));
    parents.insert(parent);
  }
  EXPECT_EQ(static_cast<int32_t>(parents.size()), coarse.cell_count());
}

}  // namespace
}  // namespace burnish
