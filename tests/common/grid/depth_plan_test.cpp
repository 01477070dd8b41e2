#include "common/grid/depth_plan.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

MeshStatistics square_statistics() {
  MeshStatistics statistics;
  statistics.box_max = Vec3d(9, 9, 0);
  statistics.area = 81;
  return statistics;
}

TEST(DepthPlan, TheCellIsTheGridsAndHalvesWithEachDepth) {
  EXPECT_DOUBLE_EQ(plan_depth(square_statistics(), 4).cell_size, 10.0 / 16);
  EXPECT_DOUBLE_EQ(plan_depth(square_statistics(), 7).cell_size, 10.0 / 128);
}

TEST(DepthPlan, CellsMemoryAndTimeGoWithTheAreaInCells) {
  const DepthPlan coarse = plan_depth(square_statistics(), 6),
                  fine = plan_depth(square_statistics(), 7);
  EXPECT_DOUBLE_EQ(fine.cells, 4 * coarse.cells);
  EXPECT_DOUBLE_EQ(fine.memory_bytes, 4 * coarse.memory_bytes);
  EXPECT_DOUBLE_EQ(fine.prepare_seconds, 4 * coarse.prepare_seconds);
  const double cells_of_plane = 81 / (coarse.cell_size * coarse.cell_size);
  EXPECT_GE(coarse.cells, cells_of_plane);
  EXPECT_LE(coarse.cells, 2 * cells_of_plane);
}

}  // namespace
}  // namespace burnish
