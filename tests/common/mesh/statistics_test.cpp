#include "common/mesh/statistics/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/mesh/statistics/heard_statistics.h"
#include "tests/common/odd_triangles.h"

namespace burnish {
namespace {

TriangleMesh mesh_of(std::vector<Vec3d> vertices, std::vector<Triangle> triangles) {
  TriangleMesh mesh;
  mesh.vertices = std::move(vertices);
  mesh.triangles = std::move(triangles);
  return mesh;
}

TriangleMesh unit_tetrahedron() {
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

TEST(Statistics, ATetrahedronIsClosedAndHasItsVolume) {
  const MeshStatistics statistics = compute_statistics(unit_tetrahedron());
  EXPECT_EQ(statistics.vertices, 4);
  EXPECT_EQ(statistics.triangles, 4);
  EXPECT_TRUE(statistics.is_closed());
  EXPECT_EQ(statistics.non_manifold_edges, 0);
  EXPECT_EQ(statistics.components, 1);
  EXPECT_NEAR(statistics.signed_volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(statistics.area, 1.5 + std::sqrt(3) / 2, 1e-15);
  EXPECT_NEAR(statistics.mean_edge_length, (1 + std::sqrt(2)) / 2, 1e-15);
  EXPECT_NEAR(statistics.diagonal(), std::sqrt(3), 1e-15);
}

TEST(Statistics, ReversedWindingHasNegativeVolume) {
  TriangleMesh mesh = unit_tetrahedron();
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_NEAR(compute_statistics(mesh).signed_volume, -1.0 / 6, 1e-15);
}

TEST(Statistics, VolumeSurvivesSurveyCoordinates) {
  TriangleMesh mesh = unit_tetrahedron();
  for (Vec3d& p : mesh.vertices) p += Vec3d(6e6, 5e6, 3e3);
  EXPECT_NEAR(compute_statistics(mesh).signed_volume, 1.0 / 6, 1e-9);
}

TEST(Statistics, ASingleTriangleHasThreeBoundaryEdges) {
  const auto statistics =
      compute_statistics(mesh_of({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(statistics.boundary_edges, 3);
  EXPECT_FALSE(statistics.is_closed());
  EXPECT_DOUBLE_EQ(statistics.area, 6);
  EXPECT_DOUBLE_EQ(statistics.mean_edge_length, 4);
}

TEST(Statistics, AFanOfThreePagesHasANonManifoldSpine) {
  const auto statistics = compute_statistics(mesh_of(
      {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}));
  EXPECT_EQ(statistics.non_manifold_edges, 1);
  EXPECT_EQ(statistics.boundary_edges, 6);
  EXPECT_EQ(statistics.components, 1);
}

TEST(Statistics, TwoTrianglesOfTheSameDirectionStillShareTheEdge) {
  const auto statistics = compute_statistics(
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(statistics.boundary_edges, 4);
  EXPECT_EQ(statistics.non_manifold_edges, 0);
}

TEST(Statistics, PiecesThatShareAVertexAreOneComponent) {
  const std::vector<Vec3d> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0},
                                       {0, 2, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
  EXPECT_EQ(compute_statistics(mesh_of(vertices, {{0, 1, 2}, {0, 3, 4}})).components, 1);
  EXPECT_EQ(compute_statistics(mesh_of(vertices, {{0, 1, 2}, {0, 3, 4}, {5, 6, 7}})).components, 2);
}

TEST(Statistics, ATriangleThatRepeatsAVertexHasNeitherEdgesNorArea) {
  const std::vector<Vec3d> vertices = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  for (const Triangle& triangle : {Triangle{0, 0, 1}, Triangle{0, 1, 0}, Triangle{1, 0, 0}}) {
    const auto statistics = compute_statistics(mesh_of(vertices, {triangle}));
    EXPECT_EQ(statistics.zero_area_triangles, 1);
    EXPECT_EQ(statistics.boundary_edges, 0);
    EXPECT_EQ(statistics.components, 1);
    EXPECT_EQ(statistics.unreferenced_vertices, 1);
    EXPECT_EQ(statistics.mean_edge_length, 0);
    EXPECT_EQ(statistics.area, 0);
  }
}

TEST(Statistics, TrianglesThatAreNoSurfaceChangeNoEdge) {
  const TriangleMesh sheet = make_sheet(5, 1, 0.1);
  const auto plain = compute_statistics(sheet);
  for (const auto& [name, mesh] : with_triangles_of_no_surface(sheet)) {
    const auto statistics = compute_statistics(mesh);
    EXPECT_EQ(statistics.boundary_edges, plain.boundary_edges) << name;
    EXPECT_EQ(statistics.non_manifold_edges, 0) << name;
    EXPECT_DOUBLE_EQ(statistics.mean_edge_length, plain.mean_edge_length) << name;
  }
}

TEST(Statistics, ATriangleOfOneVertexHasNoEdges) {
  const auto statistics = compute_statistics(mesh_of({{1, 2, 3}}, {{0, 0, 0}}));
  EXPECT_EQ(statistics.boundary_edges, 0);
  EXPECT_EQ(statistics.components, 1);
  EXPECT_EQ(statistics.mean_edge_length, 0);
  EXPECT_EQ(statistics.zero_area_triangles, 1);
}

TEST(Statistics, CollinearAndCoincidentCornersHaveZeroArea) {
  const auto statistics = compute_statistics(mesh_of(
      {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
  EXPECT_EQ(statistics.zero_area_triangles, 2);
}

TEST(Statistics, UnreferencedVerticesCountNeitherInBoxNorComponents) {
  TriangleMesh mesh = unit_tetrahedron();
  mesh.vertices.push_back({1e6, 0, 0});
  mesh.vertices.insert(mesh.vertices.begin(), Vec3d(-1e6, 0, 0));
  for (Triangle& triangle : mesh.triangles)
    for (uint32_t& v : triangle) ++v;
  const MeshStatistics statistics = compute_statistics(mesh);
  EXPECT_EQ(statistics.unreferenced_vertices, 2);
  EXPECT_EQ(statistics.components, 1);
  EXPECT_EQ(statistics.box_min, Vec3d(0, 0, 0));
  EXPECT_EQ(statistics.box_max, Vec3d(1, 1, 1));
}

TEST(Statistics, HearACancelWhileTheySortTheEdgesOfAFan) {
  constexpr uint32_t kRays = 100'000;
  TriangleMesh mesh;
  for (uint32_t v = 0; v <= kRays; ++v) mesh.vertices.emplace_back(v, v % 7, 0);
  for (uint32_t v = 1; v < kRays; ++v) mesh.triangles.push_back({0, v, v + 1});
  std::vector<double> fractions;
  const Progress watch = [&](std::string_view, double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  const MeshStatistics whole = compute_statistics(mesh, {}, {watch, "statistics"});
  EXPECT_EQ(whole.boundary_edges, kRays + 1u);
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  EXPECT_GE(fractions.size(), 12u) << "a loop was not heard";
  int left = 0;
  const Progress cancel = [&](std::string_view, double) { return --left > 0; };
  for (size_t until = 1; until <= 12; ++until) {
    left = static_cast<int>(until);
    EXPECT_THROW((void)compute_statistics(mesh, {}, {cancel, "statistics"}), WorkCancelled);
  }
}

}  // namespace
}  // namespace burnish
