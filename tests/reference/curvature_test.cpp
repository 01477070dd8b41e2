#include "tests/reference/curvature.h"

#include <gtest/gtest.h>

#include "tests/reference/shapes.h"

namespace burnish::reference {
namespace {

TEST(ReferenceCurvature, SphereHasOneOverRadiusEverywhere) {
  for (const TriangleCurvature& c : triangle_curvature(icosphere(3, 2.5))) {
    EXPECT_NEAR(c.kappa1, 0.4, 1e-12);
    EXPECT_NEAR(c.kappa2, 0.4, 1e-12);
  }
}

TEST(ReferenceCurvature, ClosedInsideOutMeshIsStillConvexButAnOpenOneIsNot) {
  TriangleMesh sphere = turned_inside_out(icosphere(3, 1));
  EXPECT_TRUE(is_inside_out(sphere));
  EXPECT_NEAR(triangle_curvature(sphere)[7].kappa2, 1, 1e-12);
  sphere.triangles.pop_back();
  EXPECT_FALSE(is_inside_out(sphere));
  EXPECT_NEAR(triangle_curvature(sphere)[7].kappa1, -1, 1e-12);
}

TEST(ReferenceCurvature, CylinderCurvesAroundAndNotAlong) {
  const TriangleMesh mesh =
      mapped(open_cylinder(120, 60, 2, 5), [](const Vec3d& p) { return Vec3d(skew_turn() * p); });
  const Vec3d axis = skew_turn() * Vec3d::UnitZ();
  for (const TriangleCurvature& c : triangle_curvature(mesh)) {
    EXPECT_NEAR(c.kappa1, 0.5, 0.01);
    EXPECT_NEAR(c.kappa2, 0, 0.01);
    EXPECT_NEAR(std::abs(c.v2.dot(axis)), 1, 1e-3);
    EXPECT_NEAR(c.v1.dot(c.v2), 0, 1e-12);
  }
}

TEST(ReferenceCurvature, SaddleHasBothSignsAndKappa1IsTheLargerOne) {
  const TriangleMesh mesh = grid_surface(80, 80, false, [](double u, double v) {
    return Vec3d(u - 0.5, v - 0.5, (u - 0.5) * (u - 0.5) - 0.5 * (v - 0.5) * (v - 0.5));
  });
  const TriangleCurvature middle = triangle_curvature(mesh)[2 * (40 * 80 + 40)];
  EXPECT_NEAR(middle.kappa1, 1, 0.01);   // from above y curves down: convex
  EXPECT_NEAR(middle.kappa2, -2, 0.02);  // and x curves up: concave
  EXPECT_NEAR(std::abs(middle.v1.y()), 1, 1e-2);
}

TEST(ReferenceCurvature, NearestAreasSumToTheAreaAlsoWhenObtuse) {
  const Vec3d a(0, 0, 0), b(4, 0, 0);
  for (double x : {-3., 0., 1., 2., 3.9, 4., 9.}) {
    const Vec3d areas = nearest_areas(a, b, Vec3d(x, 1, 0));
    EXPECT_NEAR(areas.sum(), 2, 1e-12);
    EXPECT_GT(areas.minCoeff(), 0);
  }
  EXPECT_NEAR(nearest_areas(a, b, Vec3d(2, 1, 0))[2], 1.375, 1e-12);  // obtuse at the third corner
  EXPECT_NEAR(nearest_areas(a, b, Vec3d(0, 1, 0))[0], 1, 1e-12);      // right angle at the first
}

TEST(ReferenceCurvature, TrianglesWithoutAreaChangeNothing) {
  TriangleMesh mesh = bumpy_sphere(2);
  const std::vector<TriangleCurvature> before = triangle_curvature(mesh);
  mesh.triangles.push_back({3, 3, 5});
  mesh.vertices.push_back((mesh.vertices[0] + mesh.vertices[1]) / 2);
  mesh.triangles.push_back({0, 1, static_cast<uint32_t>(mesh.vertices.size() - 1)});
  const std::vector<TriangleCurvature> after = triangle_curvature(mesh);
  for (size_t t = 0; t < before.size(); ++t) EXPECT_EQ(before[t].kappa1, after[t].kappa1);
  EXPECT_EQ(after.back().kappa1, 0);
}

}  // namespace
}  // namespace burnish::reference
