#include "client/scene/ridges.h"

#include <gtest/gtest.h>

#include "client/scene/mesh_normals.h"
#include "common/generate/generate.h"

namespace burnish {
namespace {

/// A mesh as vertex_ridges() takes it.
struct BentMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Triangle> triangles;
};

BentMesh bent(const TriangleMesh& mesh) {
  BentMesh made{{}, vertex_normals(mesh.vertices, mesh.triangles), mesh.triangles};
  for (const Vec3d& vertex : mesh.vertices) made.positions.push_back(vertex.cast<float>());
  return made;
}

TEST(Ridges, ASphereHasTheRidgeOfItsCurvatureOutsideAndItsOppositeInside) {
  for (const double radius : {0.01, 1.0 / 60, 1.0}) {
    BentMesh sphere = bent(make_icosphere(4, radius));
    const double curvature = 1 / radius, expected = curvature / (60 + curvature);
    for (const float ridge : vertex_ridges(sphere.positions, sphere.normals, sphere.triangles))
      ASSERT_NEAR(ridge, expected, 0.02 * expected);
    for (Vec3f& normal : sphere.normals) normal = -normal;
    for (const float ridge : vertex_ridges(sphere.positions, sphere.normals, sphere.triangles))
      ASSERT_NEAR(ridge, -expected, 0.02 * expected);
  }
}

TEST(Ridges, AFlatSheetAndVerticesWithoutTrianglesHaveNone) {
  BentMesh sheet = bent(make_sheet(8, 1, 0));
  sheet.positions.push_back(Vec3f::Ones());
  sheet.normals.push_back(Vec3f::UnitX());
  for (const float ridge : vertex_ridges(sheet.positions, sheet.normals, sheet.triangles))
    EXPECT_EQ(ridge, 0);
}

TEST(Ridges, AreTheMeanOverEdgesBySquaredLengthAveragedTwice) {
  // Normals lean outwards at one corner alone.
  BentMesh bend;
  bend.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  bend.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0, 1}};
  bend.triangles = {{0, 1, 2}};
  // Edges 01, 12 and 20 have the values 0.6, 0.6 and 0, and the squared lengths 1, 5 and 4.
  double ridges[3] = {0.6 / 5, 1.2 / 6, 0.6 / 9};
  for (int pass = 0; pass < 2; ++pass) {
    const double sum = ridges[0] + ridges[1] + ridges[2];
    for (double& ridge : ridges) ridge = ridge / 2 + (sum - ridge) / 4;
  }
  const auto found = vertex_ridges(bend.positions, bend.normals, bend.triangles);
  for (int v = 0; v < 3; ++v) EXPECT_NEAR(found[v], ridges[v] / (60 + ridges[v]), 1e-7);
}

TEST(Ridges, TrianglesOfPagesGiveTheSameBits) {
  const BentMesh mesh = bent(generate_scan({.kind = "blob", .vertices = 500}).value());
  std::vector<PageTriangle> small;
  for (const auto& [a, b, c] : mesh.triangles)
    small.push_back({uint16_t(a), uint16_t(b), uint16_t(c)});
  EXPECT_EQ(vertex_ridges(mesh.positions, mesh.normals, small),
            vertex_ridges(mesh.positions, mesh.normals, mesh.triangles));
}

}  // namespace
}  // namespace burnish
