#include "client/scene/thinned_triangles.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"

namespace burnish {
namespace {

TEST(ThinnedTriangles, ASmallMeshStaysAsItIs) {
  const TriangleMesh mesh = make_icosphere(3, 1);
  EXPECT_EQ(thinned_triangles(mesh, mesh.triangles.size()), mesh.triangles);
}

TEST(ThinnedTriangles, ASphereKeepsItsAreaWithATenthOfItsTriangles) {
  const TriangleMesh mesh = make_icosphere(6, 1);
  const uint64_t max = mesh.triangles.size() / 10;
  const std::vector<Triangle> triangles = thinned_triangles(mesh, max);
  EXPECT_LE(triangles.size(), max);
  EXPECT_GT(triangles.size(), max / 4);
  double area = 0;
  for (const auto& [a, b, c] : triangles)
    area +=
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
  EXPECT_NEAR(area, 4 * 3.14159, 0.03 * 4 * 3.14159);
}

TEST(ThinnedTriangles, AMeshFarFromTheOriginIsThinnedToo) {
  TriangleMesh mesh = make_icosphere(5, 1);
  for (Vec3d& vertex : mesh.vertices) vertex += Vec3d(5e6, -4e6, 2e5);
  EXPECT_LE(thinned_triangles(mesh, 1000).size(), 1000u);
  EXPECT_GT(thinned_triangles(mesh, 1000).size(), 250u);
}

}  // namespace
}  // namespace burnish
