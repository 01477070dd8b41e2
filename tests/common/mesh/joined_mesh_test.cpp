#include "common/mesh/joined_mesh.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mesh/statistics/statistics.h"

namespace burnish {
namespace {

using testing::ElementsAre;

std::vector<uint32_t> least_of(const std::vector<Vec3d>& vertices) {
  const ScratchArray<uint32_t> least = least_at_places(vertices);
  return {least.begin(), least.end()};
}

/// Two triangles that share an edge, each with vertices of its own.
TriangleMesh make_torn_square() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

TEST(JoinedMesh, NamesTheLeastVertexOfEachPlace) {
  EXPECT_THAT(least_of(make_torn_square().vertices), ElementsAre(0, 1, 2, 1, 4, 2));
}

TEST(JoinedMesh, ZeroAndMinusZeroAreOnePlace) {
  EXPECT_THAT(least_of({{0.0, 1, 2}, {-0.0, 1, 2}}), ElementsAre(0, 0));
}

TEST(JoinedMesh, VerticesThatAreNoNumbersStayApart) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(least_of({{nan, 0, 0}, {1, 0, 0}, {nan, 0, 0}, {1, 0, 0}}), ElementsAre(0, 1, 2, 1));
}

TEST(JoinedMesh, ManyVerticesAtOnePlaceAreOne) {
  const std::vector<uint32_t> least = least_of(std::vector<Vec3d>(10'000, Vec3d(1, 2, 3)));
  EXPECT_THAT(least, testing::Each(0));
}

TEST(JoinedMesh, HearsACancelWhileItSortsVerticesOfOnePlace) {
  const std::vector<Vec3d> vertices(100'000, Vec3d(1, 2, 3));
  int reports = 0;
  const Progress count = [&](std::string_view, double) { return ++reports > 0; };
  EXPECT_EQ(least_at_places(vertices, {}, {count, "joining"})[99'999], 0u);
  EXPECT_GE(reports, 5) << "two sorts, and the loops before them";
  for (int until = 1; until <= 5; ++until) {
    int left = until;
    const Progress cancel = [&](std::string_view, double) { return --left > 0; };
    EXPECT_THROW((void)least_at_places(vertices, {}, {cancel, "joining"}), WorkCancelled);
  }
}

TEST(JoinedMesh, ItsTrianglesHaveTheLeastVertices) {
  const TriangleMesh mesh = make_torn_square();
  const JoinedMesh joined(mesh, {});
  EXPECT_TRUE(joined.has_joins());
  EXPECT_THAT(joined.view().triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 4, 2}));
}

TEST(JoinedMesh, WithoutJoinsItIsTheMeshItself) {
  TriangleMesh mesh = make_torn_square();
  mesh.vertices[3].z() = mesh.vertices[5].z() = 1;
  const JoinedMesh joined(mesh, {});
  EXPECT_FALSE(joined.has_joins());
  EXPECT_EQ(joined.view().triangles.data(), mesh.triangles.data());
}

TEST(JoinedMesh, StatisticsSeeOneSurfaceAcrossASeam) {
  const MeshStatistics statistics = compute_statistics(make_torn_square());
  EXPECT_EQ(statistics.boundary_edges, 4);
  EXPECT_EQ(statistics.components, 1);
  EXPECT_EQ(statistics.unreferenced_vertices, 0);
  EXPECT_EQ(statistics.vertices, 6);
}

}  // namespace
}  // namespace burnish
