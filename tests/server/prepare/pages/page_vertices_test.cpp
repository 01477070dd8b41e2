#include "server/prepare/pages/page_vertices.h"

#include <gtest/gtest.h>

#include "common/grid/grid.h"
#include "tests/server/prepare/pages/pages_test_meshes.h"

namespace burnish {
namespace {

PageVertices place(const TriangleMesh& mesh) {
  const MeshStatistics statistics = compute_statistics(mesh);
  return place_vertices({mesh.vertices, mesh.triangles, mesh.colours, statistics}, {});
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

// Two triangles whose corners lie on the plane in the middle of the cube, all but one each.
TriangleMesh triangles_at_the_middle_plane(double peak) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, peak}, {0.5, 0.5, -peak}};
  mesh.triangles = {{0, 1, 4}, {2, 3, 5}};
  return mesh;
}

TEST(PageVertices, VerticesOnAPlaneGoToTheSideOfTheirTriangles) {
  const PageVertices placed = place(triangles_at_the_middle_plane(0.2));
  const int middle = placed.grid.steps() / 2;
  EXPECT_EQ(placed.positions[0].z(), middle);      // its triangle rises
  EXPECT_EQ(placed.positions[2].z(), middle - 1);  // its triangle falls
}

TEST(PageVertices, VerticesOfOnePlaceOnAPlaneAreJoinedWhereverTheirTrianglesLie) {
  TriangleMesh mesh = triangles_at_the_middle_plane(0.2);
  mesh.triangles = {{0, 1, 4}, {7, 6, 5}};  // a seam: one side rises, the other falls
  mesh.vertices.push_back(mesh.vertices[0]);
  mesh.vertices.push_back(mesh.vertices[1]);
  const PageVertices placed = place(mesh);
  for (const uint32_t v : {0, 1}) {
    EXPECT_EQ(placed.positions[v].z(), placed.grid.steps() / 2);
    EXPECT_EQ(placed.joined[6 + v], v);
  }
}

TEST(PageVertices, VerticesThatTheGridSnapsToAPlaneCountAsOnIt) {
  TriangleMesh mesh = triangles_at_the_middle_plane(0.2);
  mesh.vertices[0].z() = -1e-10;
  mesh.vertices[2].z() = 1e-10;
  const PageVertices placed = place(mesh);
  EXPECT_EQ(placed.positions[0].z(), placed.grid.steps() / 2);
  EXPECT_EQ(placed.positions[2].z(), placed.grid.steps() / 2 - 1);
}

TEST(PageVertices, TrianglesInAPlaneGoAbove) {
  TriangleMesh mesh = triangles_at_the_middle_plane(0);
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
