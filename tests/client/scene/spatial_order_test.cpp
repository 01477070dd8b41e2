#include "client/scene/spatial_order.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "common/generate/generate.h"

namespace burnish {
namespace {

Eigen::AlignedBox3d box_around(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3d& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

TEST(SpatialOrder, NamesEachTriangleOnce) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 3000}).value();
  std::vector<uint32_t> order = spatial_order(mesh, box_around(mesh));
  std::vector<uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_NE(order, all);
  std::ranges::sort(order);
  EXPECT_EQ(order, all);
}

TEST(SpatialOrder, OctantsComeOneAfterTheOther) {
  const TriangleMesh mesh = make_icosphere(4, 1);
  const Vec3d middle = box_around(mesh).center();
  int changes = 0, before = -1;
  for (const uint32_t number : spatial_order(mesh, box_around(mesh))) {
    Vec3d sum = Vec3d::Zero();
    for (const uint32_t vertex : mesh.triangles[number]) sum += mesh.vertices[vertex] - middle;
    if (sum.cwiseAbs().minCoeff() < 0.01) continue;  // on the plane between two
    const int octant = (sum.x() > 0) + 2 * (sum.y() > 0) + 4 * (sum.z() > 0);
    EXPECT_GE(octant, before);
    changes += octant != before;
    before = octant;
  }
  EXPECT_EQ(changes, 8);
}

TEST(SpatialOrder, TrianglesOfOnePlaceKeepTheirOrder) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}, {9, 8, 9}, {8, 9, 9}};
  mesh.triangles = {{3, 4, 5}, {0, 1, 2}, {4, 5, 3}, {2, 0, 1}, {5, 3, 4}};
  EXPECT_EQ(spatial_order(mesh, box_around(mesh)), (std::vector<uint32_t>{1, 3, 0, 2, 4}));
}

}  // namespace
}  // namespace burnish
