#include "common/measure/section.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "common/generate/generate.h"

namespace burnish {
namespace {

double length_of(const SectionLine& line) {
  double sum = 0;
  for (size_t i = 1; i < line.points.size(); ++i)
    sum += (line.points[i] - line.points[i - 1]).norm();
  return sum;
}

TEST(Section, OfASphereIsOneCircle) {
  const TriangleMesh sphere = make_icosphere(6, 2);
  const auto plane = make_plane({0, 0, 1}, {0, 0, 5});
  const auto lines = cut_surface(sphere.vertices, sphere.triangles, plane.value());
  ASSERT_EQ(lines->size(), 1u);
  EXPECT_TRUE(lines->front().is_closed());
  const double radius = std::sqrt(3.0);
  EXPECT_NEAR(length_of(lines->front()), 2 * std::numbers::pi * radius, 1e-2);
  for (const auto& point : lines->front().points) EXPECT_NEAR(point.norm(), radius, 1e-3);
}

TEST(Section, ThroughVerticesHasNoGap) {
  const TriangleMesh sphere = make_icosphere(4, 1);  // has vertices at height 0
  const auto plane = make_plane({0, 0, 0}, {0, 0, 1});
  const auto lines = cut_surface(sphere.vertices, sphere.triangles, plane.value());
  ASSERT_EQ(lines->size(), 1u);
  EXPECT_TRUE(lines->front().is_closed());
}

TEST(Section, OfAnOpenSurfaceEndsAtItsBoundary) {
  const TriangleMesh sheet = make_sheet(32, 4, 0);
  const auto plane = make_plane({1.3, 0, 0}, {1, 0, 0});
  const auto lines = cut_surface(sheet.vertices, sheet.triangles, plane.value());
  ASSERT_EQ(lines->size(), 1u);
  EXPECT_FALSE(lines->front().is_closed());
  EXPECT_NEAR(length_of(lines->front()), 4, 1e-9);
}

TEST(Section, OfSeveralPiecesHasALineForEach) {
  TriangleMesh two = make_icosphere(3, 1);
  const size_t count = two.vertices.size();
  for (size_t v = 0; v < count; ++v) two.vertices.push_back(two.vertices[v] + Vec3d(5, 0, 0));
  const std::vector<Triangle> one = two.triangles;
  for (const Triangle& t : one)
    two.triangles.push_back({t[0] + static_cast<uint32_t>(count),
                             t[1] + static_cast<uint32_t>(count),
                             t[2] + static_cast<uint32_t>(count)});
  const auto plane = make_plane({0, 0.1, 0}, {0, 1, 0});
  const auto lines = cut_surface(two.vertices, two.triangles, plane.value());
  ASSERT_EQ(lines->size(), 2u);
  for (const SectionLine& line : *lines) EXPECT_TRUE(line.is_closed());
}

TEST(Section, WhereThreeTrianglesMeetLinesEnd) {
  const std::vector<Vec3d> fan = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0.5}, {-1, 1, 0.5}, {-1, -1, 0.5}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const auto plane = make_plane({0, 0, 0}, {0, 0, 1});
  const auto lines = cut_surface(fan, triangles, plane.value());
  ASSERT_EQ(lines->size(), 3u);
  for (const SectionLine& line : *lines) EXPECT_EQ(line.points.size(), 2u);
}

TEST(Section, BesideTheSurfaceIsEmpty) {
  const TriangleMesh sphere = make_icosphere(2, 1);
  const auto plane = make_plane({0, 0, 3}, {0, 0, 1});
  EXPECT_TRUE(cut_surface(sphere.vertices, sphere.triangles, plane.value())->empty());
}

TEST(Section, WithTooManyPointsNamesTheLimit) {
  const TriangleMesh sheet = make_sheet(1000, 1, 0);
  const auto plane = make_plane({0, 0, 0}, {1, 1, 100});
  std::vector<Vec3d> rough = sheet.vertices;
  for (size_t v = 0; v < rough.size(); ++v) rough[v].z() += v % 2 == 0 ? 1 : -1;
  const auto lines = cut_surface(rough, sheet.triangles, plane.value());
  EXPECT_EQ(lines.status().code(), StatusCode::kResourceExhausted);
  EXPECT_NE(lines.status().message().find(std::to_string(kSectionPointsMax)), std::string::npos);
}

TEST(Plane, HasAxesAtRightAngles) {
  for (const Vec3d& direction :
       {Vec3d(0, 1, 0), Vec3d(0, 0, 1), Vec3d(3, -2, 0.5), Vec3d(0, -1, 0)}) {
    const auto plane = make_plane({1, 2, 3}, direction);
    const PlaneAxes axes = axes_of(plane.value());
    EXPECT_NEAR(axes.right.norm(), 1, 1e-12);
    EXPECT_NEAR(axes.up.norm(), 1, 1e-12);
    EXPECT_NEAR(axes.right.dot(axes.up), 0, 1e-12);
    EXPECT_NEAR(axes.right.cross(axes.up).dot(plane->normal), 1, 1e-12);
  }
}

TEST(Plane, WithoutADirectionIsRefused) {
  EXPECT_EQ(make_plane({0, 0, 0}, {0, 0, 0}).status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(make_plane({NAN, 0, 0}, {0, 0, 1}).status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(make_plane({0, 0, 0}, {0, 2e18, 1}).status().code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace burnish
