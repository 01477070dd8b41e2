#include "server/fields/rims.h"

#include <algorithm>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/sort_once.h"
#include "common/generate/generate.h"
#include "server/fields/edge_census.h"
#include "server/fields/hold.h"
#include "server/prepare/prepare.h"
#include "tests/common/odd_triangles.h"
#include "tests/common/split_vertices.h"

namespace burnish {
namespace {

std::shared_ptr<const PreparedMesh> prepared_with_rims(const TriangleMesh& mesh) {
  PrepareOptions options;
  options.depth = 5;
  return *prepare(mesh, options);
}

bool is_on_border(const Vec3d& p) {
  return p.x() == 0 || p.y() == 0 || p.x() == 1 || p.y() == 1;
}

void add_moved(const TriangleMesh& part, const Vec3d& by, double scale, TriangleMesh& mesh) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (const Vec3d& p : part.vertices) mesh.vertices.push_back(scale * p + by);
  for (const Triangle& t : part.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// A sheet with a hole in its middle.
TriangleMesh make_holed_sheet(double radius) {
  TriangleMesh mesh = make_sheet(100, 1, 0.1);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const Vec3d middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
    return (middle - Vec3d(0.5, 0.5, 0)).head<2>().norm() < radius;
  });
  return mesh;
}

std::vector<bool> is_held(const PreparedMesh& prepared) {
  std::vector<bool> held(prepared.vertices.size(), false);
  for (const uint32_t v : find_held_rims(prepared).vertices) held[v] = true;
  return held;
}

/// Counts the held vertices away from the border of the sheet.
int64_t held_inside(const PreparedMesh& prepared) {
  return std::ranges::count_if(find_held_rims(prepared).vertices, [&](uint32_t v) {
    return (prepared.vertices[v] - Vec3d(0.5, 0.5, 0)).head<2>().cwiseAbs().maxCoeff() < 0.4;
  });
}

TEST(Rims, HoldEachVertexOnTheBorderAndNoneInside) {
  const TriangleMesh mesh = make_sheet(40, 1, 0.1);
  const std::vector<bool> held = is_held(*prepared_with_rims(mesh));
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_EQ(held[v], is_on_border(mesh.vertices[v])) << mesh.vertices[v].transpose();
}

TEST(Rims, AreThoseOfTheSurfaceWhateverTrianglesAreNone) {
  const TriangleMesh sheet = make_sheet(12, 1, 0.1);
  for (const auto& [name, mesh] : with_triangles_of_no_surface(sheet)) {
    const std::vector<bool> held = is_held(*prepared_with_rims(mesh));
    for (const Triangle& triangle : mesh.triangles)
      for (const uint32_t v : triangle)
        EXPECT_EQ(held[v], is_on_border(mesh.vertices[v])) << name << " " << v;
  }
}

TEST(Rims, LinesHaveTheLengthOfTheRims) {
  const auto prepared = prepared_with_rims(make_sheet(40, 1, 0));
  double length = 0;
  for (const LineMass& line : find_held_rims(*prepared).lines)
    for (const double part : line.row_sum) length += part;
  EXPECT_NEAR(length * prepared->frame.cell_size, 4, 1e-4);
}

TEST(Rims, APairOfALineIsTheIntegralOfItsTwoFunctions) {
  const auto prepared = prepared_with_rims(make_sheet(40, 1, 0));
  for (const LineMass& line : find_held_rims(*prepared).lines) {
    double all = 0, pairs = 0;
    for (const double part : line.row_sum) all += part;
    for (const double part : line.pair) pairs += part;
    EXPECT_GT(pairs, 0);
    EXPECT_LT(2 * pairs, all);  // the squares are the rest of the square of the sum
  }
}

TEST(Rims, AClosedScanHasNone) {
  const HeldRims rims = find_held_rims(*prepared_with_rims(make_icosphere(3, 1)));
  EXPECT_EQ(rims.rims, 0);
  EXPECT_TRUE(rims.vertices.empty());
}

TEST(Rims, AHoleIsHeldUnlessItIsAFlawOfFewEdges) {
  EXPECT_GT(held_inside(*prepared_with_rims(make_holed_sheet(0.2))), 20);
  EXPECT_GT(held_inside(*prepared_with_rims(make_holed_sheet(0.03))), 10);
  EXPECT_EQ(held_inside(*prepared_with_rims(make_holed_sheet(0.007))), 0);
}

TEST(Rims, TheNumbersOfRimsAndOfHeldOnesAreTold) {
  const HeldRims one = find_held_rims(*prepared_with_rims(make_holed_sheet(0.007)));
  EXPECT_EQ(one.rims, 2);
  EXPECT_EQ(one.held, 1);
  EXPECT_THAT(describe(one), testing::HasSubstr("1 of 2 rims"));
  EXPECT_THAT(describe(find_held_rims(*prepared_with_rims(make_holed_sheet(0.2)))),
              testing::HasSubstr("all 2 rims"));
}

TEST(Rims, EveryDepthHoldsTheSame) {
  const auto held_at = [](int depth) {
    PrepareOptions options;
    options.depth = depth;
    return find_held_rims(**prepare(make_holed_sheet(0.05), options)).vertices;
  };
  EXPECT_EQ(held_at(4), held_at(7));
  EXPECT_EQ(held_at(9), held_at(7));
}

TEST(Rims, TheBorderOfALooseFlakeIsHeldHoweverShort) {
  TriangleMesh mesh = make_sheet(40, 1, 0);
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  add_moved(make_sheet(1, 1, 0), {0.5, 0.5, 0.5}, 0.03, mesh);
  const std::vector<bool> held = is_held(*prepared_with_rims(mesh));
  for (size_t v = first; v < mesh.vertices.size(); ++v) EXPECT_TRUE(held[v]) << v;
}

TEST(Rims, SeamsBetweenTrianglesWithTheirOwnVerticesDoNotCount) {
  const TriangleMesh sheet = make_sheet(12, 1, 0.1);
  const auto places = [](const TriangleMesh& mesh) {
    std::vector<std::tuple<double, double, double>> held;
    for (const uint32_t v : find_held_rims(*prepared_with_rims(mesh)).vertices)
      held.emplace_back(mesh.vertices[v].x(), mesh.vertices[v].y(), mesh.vertices[v].z());
    sort_once(held);
    return held;
  };
  EXPECT_EQ(places(as_soup(sheet)), places(sheet));
}

TEST(EdgeCensus, ZeroAndMinusZeroAreOnePlace) {
  TriangleMesh soup = as_soup(make_sheet(12, 1, 0.1));
  for (size_t v = 0; v < soup.vertices.size(); v += 2)
    for (double& value : soup.vertices[v])
      if (value == 0) value = -0.0;
  const EdgeCensus census = take_edge_census(soup.vertices, soup.triangles);
  const TriangleMesh sheet = make_sheet(12, 1, 0.1);
  EXPECT_EQ(census.rims.size(), take_edge_census(sheet.vertices, sheet.triangles).rims.size());
}

TEST(EdgeCensus, NamesTheLeastVertexOfEachPlaceAndTheWayOfEachRim) {
  const std::vector<Vec3d> vertices = {{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                       {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<Triangle> triangles = {{1, 2, 3}, {4, 6, 5}};
  const EdgeCensus census = take_edge_census(vertices, triangles);
  EXPECT_THAT(std::vector(census.place.begin(), census.place.end()),
              testing::ElementsAre(0, 1, 2, 3, 2, 3, 6));
  std::vector<std::pair<uint32_t, uint32_t>> rims;
  for (const RimEdge& edge : census.rims) rims.emplace_back(edge.from, edge.to);
  EXPECT_THAT(rims, testing::ElementsAre(std::pair(1u, 2u), std::pair(3u, 1u), std::pair(2u, 6u),
                                         std::pair(6u, 3u)));
  EXPECT_FALSE(census.is_closed);
}

TEST(Rims, ARimThatLiesOnAnotherPieceDoesNotCount) {
  TriangleMesh mesh = make_sheet(40, 1, 0);
  add_moved(make_sheet(12, 1, 0), {0.35, 0.35, 1e-4}, 0.3, mesh);
  const auto prepared = prepared_with_rims(mesh);
  const HeldRims rims = find_held_rims(*prepared);
  EXPECT_EQ(rims.rims, 2);
  EXPECT_EQ(rims.held, 1);
  for (const uint32_t v : rims.vertices) EXPECT_TRUE(is_on_border(mesh.vertices[v]));
}

TEST(Rims, OnlyAClosedAndOrientedSurfaceEnclosesAVolume) {
  EXPECT_TRUE(is_closed(*prepared_with_rims(make_icosphere(2, 1))));
  EXPECT_TRUE(is_closed(*prepared_with_rims(as_soup(make_icosphere(2, 1)))));
  EXPECT_FALSE(is_closed(*prepared_with_rims(make_sheet(8, 1, 0.1))));
  for (const auto& [name, mesh] : with_triangles_of_no_surface(make_icosphere(2, 1)))
    EXPECT_TRUE(is_closed(*prepared_with_rims(mesh))) << name;
  for (const auto& [name, mesh] : with_triangles_of_no_surface(make_sheet(8, 1, 0.1)))
    EXPECT_FALSE(is_closed(*prepared_with_rims(mesh))) << name;
  TriangleMesh turned = make_icosphere(2, 1);
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(is_closed(*prepared_with_rims(turned)));
}

TEST(Hold, FadesFromItsCellsToTheEndOfTheBand) {
  const auto prepared = prepared_with_rims(make_sheet(64, 1, 0));
  const Hold hold = make_hold(*prepared, {3, 4, 5, 600});
  ASSERT_EQ(hold.weight.size(), prepared->cells.size());
  for (const int32_t cell : hold.cells) EXPECT_EQ(hold.weight[cell], 1);
  EXPECT_EQ(std::ranges::count(hold.weight, 1.0f), std::ssize(hold.cells));
  EXPECT_GT(std::ranges::count(hold.weight, 0.0f), 100);
}

TEST(Hold, RaisesAlphaByAThousandAtMostAndNeverLowersIt) {
  EXPECT_DOUBLE_EQ(held_alpha(50, 0, 400), 50);
  EXPECT_DOUBLE_EQ(held_alpha(500, 1, 400), 100'000);
  EXPECT_DOUBLE_EQ(held_alpha(1, 1, 400), 1000);
  EXPECT_DOUBLE_EQ(held_alpha(1e5, 1, 400), 1e5);
}

}  // namespace
}  // namespace burnish
