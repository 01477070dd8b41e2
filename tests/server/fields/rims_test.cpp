#include "server/fields/rims.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
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

TEST(Rims, SeamsBetweenTrianglesWithTheirOwnVerticesDoNotCount) {
  const TriangleMesh sheet = make_sheet(12, 1, 0.1);
  EXPECT_EQ(rim_cells(*prepared_with_rims(as_soup(sheet))), rim_cells(*prepared_with_rims(sheet)));
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
