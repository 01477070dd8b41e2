#include "server/fields/rims.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/fields/edge_census.h"
#include "server/fields/hold.h"
#include "server/prepare/prepare.h"

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

/// Gives every triangle vertices of its own.
TriangleMesh as_soup(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<uint32_t>(soup.vertices.size());
    for (const uint32_t v : triangle) soup.vertices.push_back(mesh.vertices[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
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

/// Counts the held cells away from the border of the sheet.
int64_t held_inside(const PreparedMesh& prepared) {
  return std::ranges::count_if(rim_cells(prepared), [&](int32_t cell) {
    const Vec3d at = prepared.frame.to_file(morton_point(prepared.cells[cell]).cast<double>());
    return (at - Vec3d(0.5, 0.5, 0)).head<2>().cwiseAbs().maxCoeff() < 0.4;
  });
}

TEST(Rims, HoldTheCellOfEachVertexOnTheBorderAndNoneInside) {
  const TriangleMesh mesh = make_sheet(40, 1, 0.1);
  const auto prepared = prepared_with_rims(mesh);
  const std::vector<int32_t> cells = rim_cells(*prepared);
  const double two_cells = 2 * prepared->frame.cell_size;
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3d& p = mesh.vertices[v];
    const bool is_held = std::ranges::binary_search(cells, prepared->evaluation[v].cell);
    if (is_on_border(p)) {
      EXPECT_TRUE(is_held) << p.transpose();
    }
    const double inside = std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()});
    if (inside > two_cells) {
      EXPECT_FALSE(is_held) << p.transpose();
    }
  }
}

TEST(Rims, AClosedScanHasNone) {
  EXPECT_TRUE(rim_cells(*prepared_with_rims(make_icosphere(3, 1))).empty());
}

TEST(Rims, ALargeHoleIsHeldAndASmallOneIsNot) {
  EXPECT_GT(held_inside(*prepared_with_rims(make_holed_sheet(0.2))), 20);
  EXPECT_EQ(held_inside(*prepared_with_rims(make_holed_sheet(0.03))), 0);
}

TEST(Rims, TheLeastLengthIsSixteenCellsOfACoarseGridAndAPartOfTheBoxOfAFineOne) {
  const auto held_at = [](int depth, double radius) {
    PrepareOptions options;
    options.depth = depth;
    return held_inside(**prepare(make_holed_sheet(radius), options));
  };
  EXPECT_EQ(held_at(4, 0.1), 0);  // about 0.8 long; a cell is larger than 0.05
  EXPECT_GT(held_at(7, 0.1), 0);
  EXPECT_EQ(held_at(9, 0.005), 0);  // 0.08 at most: 16 cells are less, a twentieth is not
}

TEST(Rims, SeamsBetweenTrianglesWithTheirOwnVerticesDoNotCount) {
  const TriangleMesh sheet = make_sheet(12, 1, 0.1);
  EXPECT_EQ(rim_cells(*prepared_with_rims(as_soup(sheet))), rim_cells(*prepared_with_rims(sheet)));
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
  EXPECT_EQ(census.place, (std::vector<uint32_t>{0, 1, 2, 3, 2, 3, 6}));
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
  for (const int32_t cell : rim_cells(*prepared)) {
    const Vec3d place = prepared->frame.to_file(morton_point(prepared->cells[cell]).cast<double>());
    EXPECT_GT((place - Vec3d(0.5, 0.5, 0)).head<2>().cwiseAbs().maxCoeff(), 0.4);
  }
}

TEST(Rims, OnlyAClosedAndOrientedSurfaceEnclosesAVolume) {
  EXPECT_TRUE(is_closed(*prepared_with_rims(make_icosphere(2, 1))));
  EXPECT_TRUE(is_closed(*prepared_with_rims(as_soup(make_icosphere(2, 1)))));
  EXPECT_FALSE(is_closed(*prepared_with_rims(make_sheet(8, 1, 0.1))));
  TriangleMesh turned = make_icosphere(2, 1);
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(is_closed(*prepared_with_rims(turned)));
}

TEST(Hold, FadesFromItsCellsToTheEndOfTheBand) {
  const auto prepared = prepared_with_rims(make_sheet(64, 1, 0));
  const Hold hold = make_hold(*prepared, rim_cells(*prepared));
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
