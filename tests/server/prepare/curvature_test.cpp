#include "server/prepare/curvature.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/server/prepare/test_meshes.h"
#ifdef _OPENMP
#include <omp.h>
#endif

namespace burnish {
namespace {

using Curvature = std::vector<TriangleCurvature>;

Curvature compute_curvature(const TriangleMesh& mesh, const MeshStatistics& statistics,
                            double radius) {
  const MeshCurvature of_mesh(mesh, statistics, radius, {});
  Curvature curvature;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) curvature.push_back(of_mesh.of(t));
  return curvature;
}

Curvature closed_curvature(const TriangleMesh& mesh, double radius = 0) {
  return compute_curvature(mesh, test_statistics(mesh, true), radius);
}
Curvature open_curvature(const TriangleMesh& mesh, double radius = 0) {
  return compute_curvature(mesh, test_statistics(mesh, false), radius);
}

Vec3d centroid(const TriangleMesh& mesh, size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
}

Vec3d unit_normal(const TriangleMesh& mesh, size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vec3d& p = mesh.vertices[a];
  return (mesh.vertices[b] - p).cross(mesh.vertices[c] - p).normalized();
}

void expect_finite_and_orthonormal(const Curvature& curvature) {
  for (const TriangleCurvature& c : curvature) {
    ASSERT_TRUE(std::isfinite(c.kappa1) && std::isfinite(c.kappa2));
    ASSERT_GE(c.kappa1, c.kappa2);
    ASSERT_NEAR(c.v1.norm(), 1, 1e-9);
    ASSERT_NEAR(c.v2.norm(), 1, 1e-9);
    ASSERT_NEAR(c.v1.dot(c.v2), 0, 1e-9);
  }
}

// Adds vertex noise, the same on every machine.
TriangleMesh shaken(TriangleMesh mesh, double amplitude) {
  std::mt19937 random(7);
  for (Vec3d& p : mesh.vertices)
    for (int axis = 0; axis < 3; ++axis)
      p[axis] += amplitude * (random() / static_cast<double>(random.max()) - 0.5);
  return mesh;
}

double rms_error_against(const Curvature& curvature, double kappa) {
  double sum = 0;
  for (const TriangleCurvature& c : curvature)
    sum += std::pow(c.kappa1 - kappa, 2) + std::pow(c.kappa2 - kappa, 2);
  return std::sqrt(sum / (2 * static_cast<double>(curvature.size())));
}

TEST(Curvature, SphereIsCurvedByOneOverItsRadiusEverywhere) {
  const Curvature curvature = closed_curvature(test_sphere(4, 2.5));
  expect_finite_and_orthonormal(curvature);
  for (const TriangleCurvature& c : curvature) {
    EXPECT_NEAR(c.kappa1, 1 / 2.5, 0.01 / 2.5);
    EXPECT_NEAR(c.kappa2, 1 / 2.5, 0.01 / 2.5);
  }
}

TEST(Curvature, CylinderIsCurvedAroundAndStraightAlongItsAxis) {
  const TriangleMesh mesh = test_cylinder(0.5, 3);
  const Curvature curvature = open_curvature(mesh);
  expect_finite_and_orthonormal(curvature);
  for (size_t t = 0; t < curvature.size(); ++t) {
    const Vec3d p = centroid(mesh, t);
    if (p.x() > 0.48) continue;  // normals are one-sided at the seam
    const Vec3d around = Vec3d(-p.y(), p.x(), 0).normalized();
    EXPECT_NEAR(curvature[t].kappa1, 2, 0.02);
    EXPECT_NEAR(curvature[t].kappa2, 0, 0.02);
    EXPECT_NEAR(std::abs(curvature[t].v1.dot(around)), 1, 1e-3);
    EXPECT_NEAR(std::abs(curvature[t].v2.z()), 1, 1e-3);
  }
}

TEST(Curvature, DirectionsLieInTheTrianglesPlane) {
  const TriangleMesh mesh = shaken(test_sphere(2, 1), 0.05);
  const Curvature curvature = closed_curvature(mesh);
  for (size_t t = 0; t < curvature.size(); ++t) {
    const Vec3d normal = curvature[t].v1.cross(curvature[t].v2);
    EXPECT_NEAR(std::abs(normal.dot(unit_normal(mesh, t))), 1, 1e-12);
  }
}

TEST(Curvature, ClosedMeshTurnedInsideOutKeepsItsCurvature) {
  const TriangleMesh mesh = shaken(test_sphere(3, 1), 0.02);
  const Curvature outside = closed_curvature(mesh);
  const Curvature inside = closed_curvature(inside_out(mesh));
  for (size_t t = 0; t < outside.size(); ++t) {
    EXPECT_NEAR(inside[t].kappa1, outside[t].kappa1, 1e-9);
    EXPECT_NEAR(inside[t].kappa2, outside[t].kappa2, 1e-9);
    EXPECT_NEAR(std::abs(inside[t].v1.dot(outside[t].v1)), 1, 1e-6);
  }
}

TEST(Curvature, OpenMeshTurnedInsideOutChangesSign) {
  const TriangleMesh mesh = inside_out(test_cylinder(0.5, 3));
  const Curvature curvature = open_curvature(mesh);
  for (size_t t = 0; t < curvature.size(); ++t) {
    if (centroid(mesh, t).x() > 0.48) continue;
    EXPECT_NEAR(curvature[t].kappa1, 0, 0.02);
    EXPECT_NEAR(curvature[t].kappa2, -2, 0.02);
    EXPECT_NEAR(std::abs(curvature[t].v1.z()), 1, 1e-3);
  }
}

TEST(Curvature, SaddleIsConvexAcrossOneDiagonalAndConcaveAcrossTheOther) {
  // z = xy around the origin, facing up: concave up along x = y, convex along x = -y.
  const TriangleMesh mesh = test_patch(40, [](double u, double v) {
    const double x = (u - 0.5) / 5, y = (v - 0.5) / 5;
    return Vec3d(x, y, x * y);
  });
  const Curvature curvature = open_curvature(mesh);
  const Vec3d convex = Vec3d(1, -1, 0).normalized();
  for (size_t t = 0; t < curvature.size(); ++t) {
    if (centroid(mesh, t).head<2>().norm() > 0.08) continue;
    EXPECT_NEAR(curvature[t].kappa1, 1, 0.03);
    EXPECT_NEAR(curvature[t].kappa2, -1, 0.03);
    EXPECT_GT(std::abs(curvature[t].v1.dot(convex)), 0.99);
  }
}

TEST(Curvature, FlatSheetAndSoupAreNotCurved) {
  const TriangleMesh sheet = test_patch(8, [](double u, double v) { return Vec3d(u, v, 3); });
  TriangleMesh soup;
  for (uint32_t i = 0; i < 50; ++i) {
    for (int corner = 0; corner < 3; ++corner) soup.vertices.push_back(Vec3d(i % 7, i % 5, i % 3));
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  soup = shaken(soup, 3);
  for (const TriangleMesh& mesh : {sheet, soup}) {
    const Curvature curvature = open_curvature(mesh);
    expect_finite_and_orthonormal(curvature);
    for (const TriangleCurvature& c : curvature) {
      EXPECT_NEAR(c.kappa1, 0, 1e-9);
      EXPECT_NEAR(c.kappa2, 0, 1e-9);
    }
  }
}

TEST(Curvature, TrianglesWithoutAreaAndLooseVerticesChangeNothing) {
  const TriangleMesh mesh = test_sphere(3, 1);
  TriangleMesh dirty = mesh;
  dirty.vertices.push_back(Vec3d(1e6, 0, 0));  // without a triangle
  dirty.vertices.push_back(mesh.vertices[5]);  // a copy, in triangles without area
  const auto twin = static_cast<uint32_t>(dirty.vertices.size() - 1);
  dirty.vertices.push_back((mesh.vertices[5] + mesh.vertices[6]) / 2);
  dirty.triangles.insert(dirty.triangles.end(),
                         {{5, 5, 5}, {5, 6, 5}, {5, twin, 6}, {5, twin + 1, 6}});
  const Curvature clean = closed_curvature(mesh);
  const Curvature curvature = closed_curvature(dirty);
  expect_finite_and_orthonormal(curvature);
  for (size_t t = 0; t < clean.size(); ++t) EXPECT_EQ(curvature[t].kappa1, clean[t].kappa1);
  for (size_t t = clean.size(); t < curvature.size(); ++t) EXPECT_EQ(curvature[t].kappa1, 0);
}

TEST(Curvature, DegenerateNeighbourhoodsStayFinite) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0},   {1, 0, 0},          {0.5, 1e-9, 0},
                   {0.5, 0, 1}, {0.5, 1e-15, 1e-7}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}, {1, 0, 3}, {0, 4, 1}, {2, 4, 3}, {0, 3, 5}};
  expect_finite_and_orthonormal(open_curvature(mesh));
  expect_finite_and_orthonormal(open_curvature(mesh, 0.3));
}

TEST(Curvature, OneOverLengthUnderScaling) {
  const TriangleMesh mesh = shaken(test_sphere(3, 1), 0.02);
  const Curvature original = closed_curvature(mesh);
  for (double scale : {1e-12, 1000.0, 1e15}) {
    TriangleMesh scaled = mesh;
    for (Vec3d& p : scaled.vertices) p *= scale;
    const Curvature curvature = closed_curvature(scaled);
    for (size_t t = 0; t < original.size(); ++t)
      EXPECT_NEAR(curvature[t].kappa1 * scale, original[t].kappa1, 1e-8);
  }
}

TEST(Curvature, FollowsARigidMotion) {
  const TriangleMesh mesh = shaken(test_cylinder(0.5, 3), 0.01);
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Vec3d(1, 2, 3).normalized()).toRotationMatrix();
  TriangleMesh moved = mesh;
  for (Vec3d& p : moved.vertices) p = rotation * p + Vec3d(100, -20, 7);
  const Curvature original = open_curvature(mesh);
  const Curvature curvature = open_curvature(moved);
  for (size_t t = 0; t < original.size(); ++t) {
    EXPECT_NEAR(curvature[t].kappa1, original[t].kappa1, 1e-7);
    EXPECT_NEAR(curvature[t].kappa2, original[t].kappa2, 1e-7);
    if (original[t].kappa1 - original[t].kappa2 < 0.1) continue;  // directions are not well defined
    EXPECT_NEAR(std::abs(curvature[t].v1.dot(rotation * original[t].v1)), 1, 1e-7);
  }
}

TEST(Curvature, AveragingSteadiesANoisySphere) {
  const TriangleMesh mesh = shaken(test_sphere(4, 1), 0.01);
  const Curvature paper = closed_curvature(mesh);
  const Curvature averaged = closed_curvature(mesh, 0.25);
  expect_finite_and_orthonormal(averaged);
  EXPECT_GT(rms_error_against(paper, 1), 0.1);
  EXPECT_LT(rms_error_against(averaged, 1), rms_error_against(paper, 1) / 4);
}

TEST(Curvature, AveragingByAFewSamplesOfManyVerticesStaysTrue) {
  // Puts hundreds of vertices into each cube of the averaging grid.
  const Curvature averaged = closed_curvature(shaken(test_sphere(5, 1), 0.002), 0.5);
  for (const TriangleCurvature& c : averaged) {
    EXPECT_NEAR(c.kappa1, 1, 0.15);
    EXPECT_NEAR(c.kappa2, 1, 0.15);
  }
}

TEST(Curvature, AveragingDoesNotReachThroughAThinSheet) {
  // Two walls back to back, each curved away from the other, like a lens.
  TriangleMesh lens = test_patch(20, [](double u, double v) {
    return Vec3d(u, v, 0.01 - 0.1 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
  });
  const size_t front = lens.triangles.size();
  const auto offset = static_cast<uint32_t>(lens.vertices.size());
  TriangleMesh back = inside_out(lens);
  for (Vec3d& p : back.vertices) lens.vertices.push_back(p - Vec3d(0, 0, 0.02));
  for (const auto& [a, b, c] : back.triangles)
    lens.triangles.push_back({a + offset, b + offset, c + offset});
  const Curvature curvature = open_curvature(lens, 0.2);
  for (size_t t = 0; t < front; ++t) {
    if ((centroid(lens, t) - Vec3d(0.5, 0.5, 0)).head<2>().norm() > 0.2) continue;
    EXPECT_NEAR(curvature[t].kappa1, 0.2, 0.02);
    EXPECT_NEAR(curvature[front + t].kappa2, -0.2, 0.02);
  }
}

#ifdef _OPENMP
TEST(Curvature, SameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = shaken(test_sphere(4, 1), 0.02);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Curvature one = closed_curvature(mesh, 0.1);
  omp_set_num_threads(5);
  const Curvature five = closed_curvature(mesh, 0.1);
  omp_set_num_threads(threads);
  EXPECT_EQ(std::memcmp(one.data(), five.data(), one.size() * sizeof(one[0])), 0);
}
#endif

}  // namespace
}  // namespace burnish
