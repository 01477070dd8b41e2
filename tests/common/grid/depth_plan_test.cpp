#include "common/grid/depth_plan.h"

#include <algorithm>

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

MeshStatistics scan_of(double edge, uint64_t triangles) {
  MeshStatistics statistics = square_statistics();
  statistics.mean_edge_length = edge;
  statistics.triangles = triangles;
  return statistics;
}

// At depth 11, a cell is about 1.5 of these edges.
constexpr double kSmallEdge = 10.0 / 2048 / 1.5;
constexpr uint64_t kManyTriangles = 20'000'000;

TEST(DefaultDepth, MatchesTheEdgesWhereMemoryAllows) {
  EXPECT_EQ(default_depth(scan_of(kSmallEdge, kManyTriangles), UINT64_MAX), 11);
  EXPECT_EQ(default_depth(scan_of(kSmallEdge / 8, kManyTriangles * 64), UINT64_MAX), kDepthMax);
}

TEST(DefaultDepth, IsTheDeepestThatTheMemoryTakes) {
  const MeshStatistics scan = scan_of(kSmallEdge, kManyTriangles);
  for (int depth = kDepthMin; depth < 11; ++depth) {
    const auto just = static_cast<uint64_t>(plan_depth(scan, depth).memory_bytes);
    EXPECT_EQ(default_depth(scan, just + 1), depth);
    EXPECT_EQ(default_depth(scan, just - 1), std::max(depth - 1, kDepthMin));
  }
}

TEST(DefaultDepth, FewTrianglesDoNotAskForADeepGrid) {
  EXPECT_EQ(default_depth(scan_of(kSmallEdge, 1000), UINT64_MAX), 9);
  const MeshStatistics scan = scan_of(kSmallEdge, 0);
  const auto cells = static_cast<uint64_t>(plan_depth(scan, 10).cells);
  EXPECT_EQ(default_depth(scan_of(kSmallEdge, cells + 1), UINT64_MAX), 10);
}

}  // namespace
}  // namespace burnish
