#include "client/scene/mesh_normals.h"

#include <gtest/gtest.h>

#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

TEST(MeshNormals, ASpheresNormalsAreRadial) {
  const TriangleMesh mesh = make_test_sphere(Vec3d(1, 2, 3), 4, 64);
  const std::vector<Vec3f> normals = vertex_normals(mesh.vertices, mesh.triangles);
  double worst = 1;
  for (size_t v = 0; v < normals.size(); ++v) {
    const Vec3d radial = (mesh.vertices[v] - Vec3d(1, 2, 3)) / 4;
    worst = std::min(worst, radial.dot(normals[v].cast<double>()));
  }
  EXPECT_GT(worst, std::cos(0.02));  // a quad spans pi/64 = 0.05
}

TEST(MeshNormals, AVertexWithoutAreaHasAUnitNormal) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  for (const Vec3f& normal : vertex_normals(mesh.vertices, mesh.triangles))
    EXPECT_EQ(normal, Vec3f::UnitZ());
}

// As in scans that were simplified: its angle at the middle vertex is nearly flat.
TEST(MeshNormals, ANeedleThatFoldsOverTurnsNoNormal) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 1e-4, 1e-4}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {1, 4, 0}, {0, 4, 2}, {0, 1, 2}};
  mesh.vertices[0] = {0, 1e-5, 1e-5};  // the last triangle looks down
  const auto normals = vertex_normals(mesh.vertices, mesh.triangles);
  EXPECT_GT(normals[0].z(), 0.999f);
}

}  // namespace
}  // namespace burnish
