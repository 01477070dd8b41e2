#include "common/measure/deviation.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "common/generate/generate.h"

namespace burnish {
namespace {

std::vector<Vec3d> scaled(const std::vector<Vec3d>& points, double by) {
  std::vector<Vec3d> result = points;
  for (Vec3d& point : result) point *= by;
  return result;
}

double share_of_bins(const Deviation& deviation, int from, int to) {
  return std::accumulate(deviation.histogram.begin() + from, deviation.histogram.begin() + to, 0.0);
}

TEST(Deviation, OfASurfaceThatStaysIsZero) {
  const TriangleMesh sphere = make_icosphere(3, 2);
  const Deviation found = deviation_of(sphere.vertices, sphere.vertices, sphere.triangles);
  EXPECT_TRUE(found.is_zero());
  EXPECT_EQ(found.rms, 0);
  EXPECT_EQ(found.volume_before, found.volume_after);
  EXPECT_NEAR(share_of_bins(found, 0, Deviation::kBins), 1, 1e-12);
}

TEST(Deviation, OfASphereThatShrinksIsTheSameEverywhere) {
  const TriangleMesh sphere = make_icosphere(5, 2);
  const Deviation found =
      deviation_of(sphere.vertices, scaled(sphere.vertices, 0.9), sphere.triangles);
  EXPECT_NEAR(found.max, 0.2, 1e-12);
  EXPECT_NEAR(found.mean, 0.2, 1e-12);
  EXPECT_NEAR(found.rms, 0.2, 1e-12);
  EXPECT_NEAR(found.mean_along_normal, -0.2, 1e-4);
  EXPECT_NEAR(found.inward_max, 0.2, 1e-4);
  EXPECT_EQ(found.outward_max, 0);
  EXPECT_NEAR(found.volume_after / found.volume_before, 0.729, 1e-12);
  EXPECT_NEAR(found.area_after / found.area_before, 0.81, 1e-12);
  EXPECT_GT(share_of_bins(found, 0, 1), 0.9);
}

/// The same triangles, each with vertices of its own.
std::vector<Vec3d> corners_of(const std::vector<Vec3d>& vertices,
                              const std::vector<Triangle>& triangles) {
  std::vector<Vec3d> corners;
  for (const Triangle& triangle : triangles)
    for (const uint32_t vertex : triangle) corners.push_back(vertices[vertex]);
  return corners;
}

TEST(Deviation, OfASoupIsThatOfTheSurface) {
  const TriangleMesh sphere = make_icosphere(3, 2);
  std::vector<Vec3d> after = scaled(sphere.vertices, 0.9);
  for (size_t v = 0; v < after.size(); v += 3) after[v].x() += 0.3;
  std::vector<Triangle> triangles(sphere.triangles.size());
  for (uint32_t t = 0; t < triangles.size(); ++t) triangles[t] = {3 * t, 3 * t + 1, 3 * t + 2};
  const Deviation whole = deviation_of(sphere.vertices, after, sphere.triangles);
  const Deviation soup = deviation_of(corners_of(sphere.vertices, sphere.triangles),
                                      corners_of(after, sphere.triangles), triangles);
  EXPECT_NEAR(soup.mean_along_normal, whole.mean_along_normal, 1e-12);
  EXPECT_NEAR(soup.outward_max, whole.outward_max, 1e-12);
  EXPECT_NEAR(soup.inward_max, whole.inward_max, 1e-12);
  EXPECT_NEAR(soup.rms, whole.rms, 1e-12);
}

TEST(Deviation, OfSidesBackToBackIsThatOfEach) {
  const std::vector<Vec3d> before = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                     {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<Vec3d> after = before;
  for (Vec3d& point : after) point.z() += 2;
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 5, 4}};
  const Deviation found = deviation_of(before, after, triangles);
  EXPECT_DOUBLE_EQ(found.outward_max, 2);
  EXPECT_DOUBLE_EQ(found.inward_max, 2);
}

TEST(Deviation, WeighsAVertexByItsArea) {
  // Two unit squares; the one vertex that moves is the corner of one triangle of area 1/2.
  const std::vector<Vec3d> before = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                     {5, 0, 0}, {7, 0, 0}, {5, 3, 0}};
  std::vector<Vec3d> after = before;
  after[0].z() = 6;
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 4, 5}};
  const Deviation found = deviation_of(before, after, triangles);
  EXPECT_DOUBLE_EQ(found.area_before, 3.5);
  EXPECT_DOUBLE_EQ(found.mean, 6 * (0.5 / 3) / 3.5);
  EXPECT_DOUBLE_EQ(found.rms, std::sqrt(36 * (0.5 / 3) / 3.5));
  EXPECT_DOUBLE_EQ(found.outward_max, 6);
  EXPECT_EQ(found.farthest, Vec3d(0, 0, 0));
}

TEST(Deviation, SaysHowFarTheSurfaceMovedAlongEachAxis) {
  const std::vector<Vec3d> before = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                     {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  std::vector<Vec3d> after = before;
  for (size_t v = 0; v < 3; ++v) after[v].z() = -6;
  for (size_t v = 3; v < 6; ++v) after[v] += Vec3d(0, 1, 2);
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 4, 5}};
  const auto axes = deviation_of(before, after, triangles).axes;
  ASSERT_TRUE(axes.has_value());
  const auto& [x, y, z] = *axes;
  EXPECT_EQ(x.farthest(), 0);
  EXPECT_EQ(x.rms, 0);
  EXPECT_DOUBLE_EQ(y.most, 1);
  EXPECT_EQ(y.least, 0);
  EXPECT_DOUBLE_EQ(y.mean, 0.5);
  EXPECT_DOUBLE_EQ(z.farthest(), -6);
  EXPECT_DOUBLE_EQ(z.most, 2);
  EXPECT_DOUBLE_EQ(z.mean, -2);
  EXPECT_DOUBLE_EQ(z.rms, std::sqrt(20));
  EXPECT_DOUBLE_EQ(z.reversed().farthest(), 6);
  EXPECT_DOUBLE_EQ(z.reversed().mean, 2);
}

TEST(Deviation, DoesNotCountVerticesWithoutATriangle) {
  const std::vector<Vec3d> before = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};
  std::vector<Vec3d> after = before;
  after[3].x() = 100;
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  EXPECT_TRUE(deviation_of(before, after, triangles).is_zero());
}

TEST(Deviation, IsExactFarFromZero) {
  const TriangleMesh sphere = make_icosphere(4, 2);
  std::vector<Vec3d> before = sphere.vertices, after = scaled(sphere.vertices, 0.5);
  const Vec3d far(5e5, 5e6, 100);
  for (Vec3d& point : before) point += far;
  for (Vec3d& point : after) point += far;
  const Deviation found = deviation_of(before, after, sphere.triangles);
  EXPECT_NEAR(found.volume_after / found.volume_before, 0.125, 1e-7);
  EXPECT_NEAR(found.max, 1, 1e-8);
}

}  // namespace
}  // namespace burnish
