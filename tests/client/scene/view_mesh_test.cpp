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

}  // namespace
}  // namespace burnish
