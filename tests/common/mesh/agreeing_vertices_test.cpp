#include "common/mesh/agreeing_vertices.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/split_vertices.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<uint32_t> agreeing(const TriangleMesh& mesh) {
  const ScratchArray<uint32_t> least = least_that_agree(mesh);
  return {least.begin(), least.end()};
}

/// Two squares that share an edge of the x axis, each with vertices of its own: 0 and 1 are at the
/// places of 5 and 4. The second one is turned from the plane of the first one.
TriangleMesh make_fold(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double y = -std::cos(angle), z = -std::sin(angle);
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                   {1, 0, 0}, {0, 0, 0}, {0, y, z}, {1, y, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  return mesh;
}

const std::vector<uint32_t> kJoined = {0, 1, 2, 3, 1, 0, 6, 7};
const std::vector<uint32_t> kApart = {0, 1, 2, 3, 4, 5, 6, 7};

TEST(AgreeingVertices, AreNoneWhereNoVerticesMeet) {
  TriangleMesh mesh = make_fold(0);
  mesh.vertices.resize(4);
  mesh.triangles.resize(2);
  EXPECT_THAT(agreeing(mesh), IsEmpty());
}

TEST(AgreeingVertices, AreOneAtASeam) {
  EXPECT_EQ(agreeing(make_fold(0)), kJoined);
  EXPECT_EQ(agreeing(make_fold(50)), kJoined);
}

TEST(AgreeingVertices, StayApartAtACreaseAndBackToBack) {
  EXPECT_EQ(agreeing(make_fold(70)), kApart);
  EXPECT_EQ(agreeing(make_fold(179)), kApart);
}

TEST(AgreeingVertices, OfASoupStayApartBackToBackAlone) {
  EXPECT_THAT(agreeing(as_soup(make_fold(100))), ElementsAre(0, 1, 2, 0, 2, 5, 1, 0, 8, 1, 8, 11));
  EXPECT_THAT(agreeing(as_soup(make_fold(179))), ElementsAre(0, 1, 2, 0, 2, 5, 6, 7, 8, 6, 8, 11));
}

TEST(AgreeingVertices, StayApartWithOtherColours) {
  TriangleMesh mesh = make_fold(0);
  mesh.colours.resize(8, {1, 1, 1, 255});
  mesh.colours[4] = {2, 1, 1, 255};
  EXPECT_THAT(agreeing(mesh), ElementsAre(0, 1, 2, 3, 4, 0, 6, 7));
}

TEST(AgreeingVertices, WithoutATriangleBringNoTwoSidesTogether) {
  TriangleMesh mesh = make_fold(179);
  mesh.vertices.insert(mesh.vertices.begin(), Vec3d(0, 0, 0));
  mesh.vertices.emplace_back(1, 0, 0);
  for (Triangle& triangle : mesh.triangles)
    for (uint32_t& vertex : triangle) ++vertex;
  EXPECT_THAT(agreeing(mesh), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 2));
}

}  // namespace
}  // namespace burnish
