#include "common/mesh/statistics/thin_walls.h"

#include <random>

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "tests/server/prepare/test_meshes.h"

namespace burnish {
namespace {

constexpr int kPlatesDepth = 5;

ThinWalls walls_of(const TriangleMesh& mesh, int depth = kPlatesDepth, int threads = 0) {
  PrepareOptions options;
  options.depth = depth;
  options.threads = threads;
  const auto prepared = prepare(mesh, options);
  EXPECT_TRUE(prepared.is_ok()) << prepared.status().message();
  return (*prepared)->walls;
}

/// Two squares of side 1 that face away from each other, or both alike, tilted to the grid.
TriangleMesh plates(double apart, bool face_away = true) {
  const Eigen::AngleAxisd turn(0.7, Vec3d(1, -2, 0.5).normalized());
  TriangleMesh mesh =
      test_patch(40, [&](double u, double v) -> Vec3d { return turn * Vec3d(u, v, apart); });
  const TriangleMesh other = test_patch(40, [&](double u, double v) -> Vec3d {
    return turn * (face_away ? Vec3d(v, u, 0) : Vec3d(u, v, 0));
  });
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles)
    mesh.triangles.push_back({first + a, first + b, first + c});
  return mesh;
}

double cells(double number) {
  const auto statistics = compute_statistics(plates(0.01));
  return number * make_grid_frame(statistics.box_min, statistics.box_max, kPlatesDepth).cell_size;
}

TriangleMesh noisy(TriangleMesh mesh, double edges) {
  std::mt19937 random(1);
  std::normal_distribution<double> move(0, edges * compute_statistics(mesh).mean_edge_length);
  for (Vec3d& vertex : mesh.vertices) vertex += Vec3d(move(random), move(random), move(random));
  return mesh;
}

TEST(ThinWalls, PlatesHalfACellApartAreTold) {
  EXPECT_GT(walls_of(plates(cells(0.5))).share, 0.9);
  EXPECT_GT(walls_of(inside_out(plates(cells(0.5)))).share, 0.9);
}

TEST(ThinWalls, PlatesThreeCellsApartAreNot) {
  EXPECT_EQ(walls_of(plates(cells(3))).share, 0);
}

TEST(ThinWalls, TheDepthToldLeavesNothingToTell) {
  const TriangleMesh mesh = plates(cells(0.3));
  EXPECT_EQ(walls_of(mesh).depth, kPlatesDepth + 2);
  EXPECT_GT(walls_of(mesh, kPlatesDepth + 1).share, 0.9);
  EXPECT_EQ(walls_of(mesh, kPlatesDepth + 2).share, 0);
}

TEST(ThinWalls, NoDepthIsToldForWallsThatNoneParts) {
  const ThinWalls walls = walls_of(plates(cells(0.002)), 8);
  EXPECT_GT(walls.share, 0.9);
  EXPECT_EQ(walls.depth, 0);
}

TEST(ThinWalls, OnlyAPartOfTheSurfaceCounts) {
  // A patch as large as the plates lies beside them, in their plane.
  TriangleMesh mesh = plates(cells(0.3));
  const TriangleMesh beside = plates(cells(9));
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  const Vec3d along = mesh.vertices[40] - mesh.vertices[0];
  for (const Vec3d& vertex : beside.vertices) mesh.vertices.push_back(vertex + 1.5 * along);
  for (const auto& [a, b, c] : beside.triangles)
    mesh.triangles.push_back({first + a, first + b, first + c});
  EXPECT_NEAR(walls_of(mesh).share, 0.5, 0.05);
}

TEST(ThinWalls, AScanWithoutThemSaysNothing) {
  EXPECT_EQ(walls_of(test_sphere(4, 1)).share, 0);
  for (const char* kind : {"tablet", "blob", "part", "sheet", "cylinder"})
    EXPECT_EQ(walls_of(*generate_scan({kind, 20'000, 1}), 0).share, 0) << kind;
}

TEST(ThinWalls, NoiseIsNoWall) {
  EXPECT_EQ(walls_of(noisy(test_sphere(4, 1), 0.2), 0).share, 0);
  EXPECT_EQ(walls_of(noisy(*generate_scan({"tablet", 20'000, 1}), 0.2), 0).share, 0);
}

TEST(ThinWalls, ScansThatOverlapAreNoWall) {
  EXPECT_EQ(walls_of(plates(cells(0.3), false)).share, 0);
  EXPECT_EQ(walls_of(*generate_scan({"soup", 20'000, 1}), 0).share, 0);
}

TEST(ThinWalls, OneFaceTwiceIsNoWall) {
  EXPECT_EQ(walls_of(plates(0)).share, 0);
}

TEST(ThinWalls, AWallFromTomographyIsTold) {
  EXPECT_GT(walls_of(*generate_scan({"wall", 20'000, 1}), 0).share, 0.2);
}

TEST(ThinWalls, ThreadsChangeNothing) {
  const TriangleMesh mesh = *generate_scan({"wall", 20'000, 1});
  const int threads = thread_count();
  const ThinWalls one = walls_of(mesh, 0, 1), three = walls_of(mesh, 0, 3);
  use_threads(threads);
  EXPECT_EQ(one.share, three.share);
  EXPECT_EQ(one.depth, three.depth);
}

}  // namespace
}  // namespace burnish
