#include "client/tools/stroke_tint.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr int kDepth = 5;

PageGrid grid_of_side(double side) {
  return {Vec3d(-1, 2, 5), side, 20};
}

/// All cells of a slice of the grid.
std::vector<Vec3i> slice_of_cells(int z) {
  std::vector<Vec3i> cells;
  for (int y = 0; y < 1 << kDepth; ++y)
    for (int x = 0; x < 1 << kDepth; ++x) cells.emplace_back(x, y, z);
  return cells;
}

float strongest(const std::vector<float>& weights) {
  return weights.empty() ? 0 : *std::ranges::max_element(weights);
}

TEST(StrokeTint, ADabTintsTheCellsInItsBallByTheServersFallOff) {
  const PageGrid grid = grid_of_side(4);
  StrokeTint tint(grid, kDepth);
  const Vec3d centre = grid.origin + Vec3d(1.5, 2, 2);
  const Brush brush{.radius = 0.8, .strength = 0.5, .beta = 0};
  tint.add_dab(brush, centre);
  const std::vector<Vec3i> cells = slice_of_cells(16);
  TintProgress progress;
  std::vector<float> weights;
  EXPECT_TRUE(tint.update(cells, progress, weights));
  ASSERT_EQ(weights.size(), cells.size());
  for (size_t c = 0; c < cells.size(); ++c) {
    const Vec3d at = grid.origin + (cells[c].cast<double>() + Vec3d::Constant(0.5)) * 4 / 32;
    const double expected = 0.5 * fall_off_weight(brush.fall_off, (at - centre).norm() / 0.8);
    ASSERT_NEAR(weights[c], expected, 1e-4);
  }
  EXPECT_GT(strongest(weights), 0.4f);
}

TEST(StrokeTint, DabsAddUpToOneAndAreGoneAfterClear) {
  const PageGrid grid = grid_of_side(4);
  StrokeTint tint(grid, kDepth);
  const std::vector<Vec3i> cells = slice_of_cells(16);
  TintProgress progress;
  std::vector<float> weights;
  for (int i = 0; i < 50; ++i)
    tint.add_dab({.radius = 0.5, .strength = 0.3, .beta = 2}, grid.origin + Vec3d(2, 2, 2));
  EXPECT_TRUE(tint.update(cells, progress, weights));
  EXPECT_GT(strongest(weights), 0.9f);
  EXPECT_LE(strongest(weights), 1.0f);
  tint.clear();
  EXPECT_TRUE(tint.is_clear());
  EXPECT_TRUE(tint.update(cells, progress, weights));
  EXPECT_EQ(strongest(weights), 0.0f);
}

TEST(StrokeTint, ALaterLookAddsOnlyTheNewDabs) {
  const PageGrid grid = grid_of_side(4);
  StrokeTint tint(grid, kDepth);
  const std::vector<Vec3i> cells = slice_of_cells(16);
  TintProgress early, late;
  std::vector<float> step_by_step, at_once;
  for (int i = 0; i < 5; ++i) {
    tint.add_dab({.radius = 0.5, .strength = 0.3, .beta = 2},
                 grid.origin + Vec3d(1 + 0.2 * i, 2, 2));
    EXPECT_TRUE(tint.update(cells, early, step_by_step));
    EXPECT_FALSE(tint.update(cells, early, step_by_step));
  }
  EXPECT_TRUE(tint.update(cells, late, at_once));
  EXPECT_EQ(step_by_step, at_once);
}

TEST(StrokeTint, CellsOutOfReachAreNotTouched) {
  const PageGrid grid = grid_of_side(4);
  StrokeTint tint(grid, kDepth);
  tint.add_dab({.radius = 0.5, .strength = 0.3, .beta = 2}, grid.origin + Vec3d(2, 2, 2));
  TintProgress progress;
  std::vector<float> weights;
  EXPECT_FALSE(tint.update(slice_of_cells(31), progress, weights));
  EXPECT_TRUE(weights.empty());
}

}  // namespace
}  // namespace burnish
