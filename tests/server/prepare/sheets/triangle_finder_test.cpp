#include "server/prepare/sheets/triangle_finder.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

const PageGrid kGrid = {.origin = Vec3d::Zero(), .side = 16, .bits = 12};

/// Two triangles that meet, and the first one turned over.
TriangleMesh two_sides() {
  TriangleMesh mesh;
  mesh.vertices = {{1.01, 1.01, 1.01}, {5.01, 1.01, 1.01}, {1.01, 5.01, 1.01}, {5.01, 5.01, 3.01}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 2, 1}};
  return mesh;
}

std::array<Vec3i, 3> places_of(const TriangleMesh& mesh, const Triangle& triangle) {
  std::array<Vec3i, 3> places;
  for (int k = 0; k < 3; ++k) places[k] = kGrid.quantise(mesh.vertices[triangle[k]]);
  return places;
}

TEST(TriangleFinder, FindsATriangleWhicheverCornerComesFirst) {
  const TriangleMesh mesh = two_sides();
  const TriangleFinder finder(mesh, kGrid, {});
  for (uint32_t t = 0; t < 3; ++t)
    for (int turn = 0; turn < 3; ++turn) {
      const Triangle& own = mesh.triangles[t];
      const Triangle turned = {own[turn], own[(turn + 1) % 3], own[(turn + 2) % 3]};
      const auto found = finder.find(places_of(mesh, turned));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->triangle, t);
      EXPECT_EQ(found->turn, turn);
    }
}

TEST(TriangleFinder, OfSeveralAtOnePlaceTakesTheFirst) {
  TriangleMesh mesh = two_sides();
  mesh.triangles.push_back({2, 0, 1});
  EXPECT_EQ(TriangleFinder(mesh, kGrid, {}).find(places_of(mesh, mesh.triangles[3]))->triangle, 0u);
}

TEST(TriangleFinder, SaysThatThereIsNone) {
  const TriangleMesh mesh = two_sides();
  EXPECT_FALSE(TriangleFinder(mesh, kGrid, {}).find(places_of(mesh, {0, 1, 3})));
}

}  // namespace
}  // namespace burnish
