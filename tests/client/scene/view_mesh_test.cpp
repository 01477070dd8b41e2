#include "client/scene/view_mesh.h"

#include <gtest/gtest.h>

#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

TEST(ViewMesh, PositionsKeepTheirDetailFarFromTheOrigin) {
  const Vec3d far(5e6, -4e6, 2e5);
  const ViewMesh near_view = make_view_mesh(make_test_sphere(Vec3d::Zero(), 0.5));
  const ViewMesh far_view = make_view_mesh(make_test_sphere(far, 0.5));
  for (size_t v = 0; v < near_view.positions.size(); ++v)
    ASSERT_LT((near_view.positions[v] - far_view.positions[v]).norm(), 1e-6);
}

TEST(ViewMesh, BoxLeavesOutVerticesThatNoTriangleReferences) {
  TriangleMesh mesh = make_test_sphere(Vec3d::Zero(), 2);
  mesh.vertices.emplace_back(1000, 1000, 1000);
  EXPECT_NEAR(make_view_mesh(mesh).box.max().maxCoeff(), 2, 1e-12);
}

TEST(ViewMesh, ASpheresNormalsAreRadial) {
  const TriangleMesh mesh = make_test_sphere(Vec3d(1, 2, 3), 4, 64);
  const std::vector<Vec3f> normals = vertex_normals(mesh.vertices, mesh.triangles);
  double worst = 1;
  for (size_t v = 0; v < normals.size(); ++v) {
    const Vec3d radial = (mesh.vertices[v] - Vec3d(1, 2, 3)) / 4;
    worst = std::min(worst, radial.dot(normals[v].cast<double>()));
  }
  EXPECT_GT(worst, std::cos(0.02));  // a quad spans pi/64 = 0.05
}

TEST(ViewMesh, AVertexWithoutAreaHasAUnitNormal) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  for (const Vec3f& normal : vertex_normals(mesh.vertices, mesh.triangles))
    EXPECT_EQ(normal, Vec3f::UnitZ());
}

TEST(ViewMesh, ASphereIsARidgeOutsideAndAGrooveInside) {
  TriangleMesh mesh = make_test_sphere(Vec3d::Zero(), 1);
  const ViewMesh outside = make_view_mesh(mesh);
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  const ViewMesh inside = make_view_mesh(mesh);
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    EXPECT_GT(outside.ridges[v], 0);
    EXPECT_LT(inside.ridges[v], 0);
  }
}

}  // namespace
}  // namespace burnish
