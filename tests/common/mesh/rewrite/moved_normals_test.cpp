#include "common/mesh/rewrite/moved/moved_normals.h"

#include <gtest/gtest.h>

#include "common/mesh/rewrite/patch/written_mesh.h"

namespace burnish {
namespace {

TEST(MovedNormals, ALengthNearOneBecomesOneAndOthersStay) {
  const AreaVectors areas = {Vec3d(0, 0, 2), Vec3d(5, 0, 0)};
  EXPECT_EQ(areas.turn(Vec3d(0, 0, 0.9995)), Vec3d(1, 0, 0));
  EXPECT_EQ(areas.turn(Vec3d(0, 0, 127)), Vec3d(127, 0, 0));
}

TEST(MovedNormals, ASurfaceWithoutAreaKeepsItsNormal) {
  const AreaVectors areas = {Vec3d(0, 0, 2), Vec3d(0, 0, 0)};
  EXPECT_EQ(areas.turn(Vec3d(0.6, 0, 0.8)), Vec3d(0.6, 0, 0.8));
}

TEST(MovedNormals, AMoveBelowAFloatIsNoMove) {
  TriangleMesh after;
  const std::vector<Vec3d> before = {Vec3d(1, 0, 0), Vec3d(2, 0, 0), Vec3d(1, 1, 0)};
  after.vertices = before;
  after.vertices[1][2] = 1e-60;
  after.triangles = {{0, 1, 2}};
  const Vec3d normal(0.6, 0, 0.8);
  const auto turned = [&](PlyType type) {
    const MovedMesh moved{before, after};
    const WrittenMesh written(moved, WrittenNumber{.type = type, .digits = {}});
    return gather_vertex_areas(written.moved())[0].turn(normal);
  };
  EXPECT_EQ(turned(PlyType::kFloat32), normal);
  EXPECT_EQ(turned(PlyType::kFloat64), Vec3d(-1e-60, 0, 1));
}

}  // namespace
}  // namespace burnish
