#include "server/prepare/pages/page_vertices.h"

#include <gtest/gtest.h>

#include "common/grid/grid.h"
#include "tests/server/prepare/pages/pages_test_meshes.h"

namespace burnish {
namespace {

PageVertices place(const TriangleMesh& mesh) {
  const MeshStatistics statistics = compute_statistics(mesh);
  return place_vertices({mesh.vertices, mesh.triangles, mesh.colours, statistics});
}

TEST(PageVertices, StepsAreAtMostA256thOfTheMeanEdge) {
  const TriangleMesh mesh = scan_of_kind("blob", 20'000);
  const PageGrid grid = place(mesh).grid;
  EXPECT_LE(grid.step(), compute_statistics(mesh).mean_edge_length / 256);
  EXPECT_GT(grid.step(), compute_statistics(mesh).mean_edge_length / 1024);
}

TEST(PageVertices, TheCubeIsThatOfAllGrids) {
  const TriangleMesh mesh = scan_of_kind("blob", 20'000);
  const MeshStatistics statistics = compute_statistics(mesh);
  const PageGrid grid = place(mesh).grid;
  for (int depth = kDepthMin; depth <= kDepthMax; ++depth) {
    const GridFrame frame = make_grid_frame(statistics.box_min, statistics.box_max, depth);
    EXPECT_EQ(grid.origin, frame.origin);
    EXPECT_EQ(grid.side, frame.cell_size * frame.cells_per_side());
  }
}

// The box of this sheet is flat, so all of it lies on the plane in the middle of the cube.
TriangleMesh flat_sheet_with_peak(double peak) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, peak}, {0.5, 0.5, -peak}};
  mesh.triangles = {{0, 1, 4}, {2, 3, 5}};
  return mesh;
}

TEST(PageVertices, VerticesOnAPlaneGoToTheSideOfTheirTriangles) {
  const PageVertices placed = place(flat_sheet_with_peak(0.2));
  const int middle = placed.grid.steps() / 2;
  EXPECT_EQ(placed.positions[0].z(), middle);      // its triangle rises
  EXPECT_EQ(placed.positions[2].z(), middle - 1);  // its triangle falls
}

TEST(PageVertices, TrianglesInAPlaneGoAbove) {
  TriangleMesh mesh = flat_sheet_with_peak(0);
  const PageVertices placed = place(mesh);
  for (const Vec3i& position : placed.positions) EXPECT_EQ(position.z(), placed.grid.steps() / 2);
}

TEST(PageVertices, VerticesOfOnePlaceAreJoinedWithTheLeast) {
  TriangleMesh mesh = scan_of_kind("blob", 1'000);
  const auto twin = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(mesh.vertices[17]);
  mesh.triangles.push_back({twin, 0, 1});
  const PageVertices placed = place(mesh);
  EXPECT_EQ(placed.joined[twin], 17u);
  EXPECT_EQ(placed.joined[17], 17u);
  EXPECT_EQ(placed.joined[18], 18u);
}

TEST(PageVertices, FarVerticesWithoutTrianglesDoNoHarm) {
  TriangleMesh mesh = scan_of_kind("blob", 1'000);
  const PageVertices placed = place(mesh);
  mesh.vertices.push_back({1e18, -1e18, 0});
  EXPECT_EQ(place(mesh).positions[5], placed.positions[5]);
}

}  // namespace
}  // namespace burnish
