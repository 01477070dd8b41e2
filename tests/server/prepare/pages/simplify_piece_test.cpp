#include "server/prepare/pages/simplify_piece.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/pages/cluster_vertices.h"
#include "server/prepare/pages/kept_border.h"
#include "tests/server/prepare/pages/pages_test_meshes.h"
#include "tests/server/prepare/pages/piece_of_mesh.h"

namespace burnish {
namespace {

bool is_on_the_left(const Vec3d& p) {
  return p.x() < 1e-9;
}
bool is_nowhere(const Vec3d&) {
  return false;
}

/// A sheet at the tip of whose thin last triangle another page begins.
PagePiece sheet_with_tip() {
  TriangleMesh sheet = make_sheet(20, 1, 0);
  const auto tip = static_cast<uint32_t>(sheet.vertices.size());
  sheet.vertices.emplace_back(-1e-4, 0.025, 0);
  uint32_t low = 0, high = 0;
  for (uint32_t v = 0; v < tip; ++v) {
    if (sheet.vertices[v].isApprox(Vec3d(0, 0, 0), 1e-9)) low = v;
    if (sheet.vertices[v].isApprox(Vec3d(0, 0.05, 0), 1e-9)) high = v;
  }
  sheet.triangles.push_back({low, high, tip});
  return piece_of(sheet, [](const Vec3d& p) { return p.x() < 0; });
}

TEST(KeptBorder, MissesATipThatIsJoinedAway) {
  const PagePiece piece = sheet_with_tip();
  const SimplePiece simple = cluster_vertices(piece, piece.triangles.size() / 2);
  EXPECT_EQ(KeptBorder(piece).find_lost(simple.triangles),
            std::vector{static_cast<uint32_t>(piece.vertices.size() - 1)});
}

TEST(KeptBorder, MissesAnEdgeThatIsPassedTheOtherWay) {
  PagePiece piece;
  piece.vertices = {0, 1, 2};
  piece.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  piece.locked = {1, 1, 0};
  piece.triangles = {{0, 1, 2}};
  EXPECT_TRUE(KeptBorder(piece).find_lost(piece.triangles).empty());
  EXPECT_EQ(KeptBorder(piece).find_lost({{1, 0, 2}}), (std::vector<uint32_t>{0, 1}));
}

TEST(SimplifyPiece, KeepsATipThatAnotherPageHolds) {
  const PagePiece piece = sheet_with_tip();
  for (const auto by : {SimplifyBy::kCollapse, SimplifyBy::kCluster}) {
    const SimplePiece simple = simplify_piece(piece, by);
    EXPECT_TRUE(KeptBorder(piece).find_lost(simple.triangles).empty());
    EXPECT_LT(simple.triangles.size(), 0.6 * piece.triangles.size());
  }
}

TEST(SimplifyPiece, LeavesHalfTheTriangles) {
  const PagePiece piece = piece_of(make_sheet(40, 1, 0.2), is_on_the_left);
  const size_t half = piece.triangles.size() / 2;
  EXPECT_NEAR(simplify_piece(piece, SimplifyBy::kCollapse).triangles.size(), half, 4);
}

TEST(SimplifyPiece, LeavesMoreWhereFewVerticesAreFree) {
  const PagePiece piece =
      piece_of(make_sheet(40, 1, 0.2), [](const Vec3d& p) { return p.x() < 0.3 || p.x() > 0.7; });
  const size_t triangles = piece.triangles.size();
  const SimplePiece some = simplify_piece(piece, SimplifyBy::kCollapse);
  const SimplePiece more = simplify_piece(piece, SimplifyBy::kCollapseMore);
  EXPECT_GT(some.triangles.size(), 0.7 * triangles);
  EXPECT_LT(some.triangles.size(), 0.8 * triangles);
  EXPECT_LT(more.triangles.size(), some.triangles.size());
  EXPECT_LT(10 * some.error, more.error);
}

TEST(SimplifyPiece, ClusteringKeepsTheBorderToo) {
  const PagePiece piece = piece_of(make_sheet(40, 1, 0.2), is_on_the_left);
  const SimplePiece simple = simplify_piece(piece, SimplifyBy::kCluster);
  EXPECT_TRUE(KeptBorder(piece).find_lost(simple.triangles).empty());
  EXPECT_LE(simple.triangles.size(), piece.triangles.size() / 2);
  EXPECT_GT(simple.error, 0);
}

TEST(SimplifyPiece, NeverLeavesNothing) {
  const PagePiece small_component = piece_of(small_components(1), is_nowhere);
  for (const auto by : {SimplifyBy::kCollapse, SimplifyBy::kCluster, SimplifyBy::kDrop})
    EXPECT_GE(simplify_piece(small_component, by).triangles.size(), 1u);
}

TEST(DropSmallTriangles, KeepsTheLargestInTheirOrder) {
  PagePiece piece;
  for (const float size : {1.0f, 3.0f, 2.0f}) {
    const auto first = static_cast<uint32_t>(piece.positions.size());
    piece.triangles.push_back({first, first + 1, first + 2});
    for (const Vec3f& corner : {Vec3f(0, 0, 0), Vec3f(size, 0, 0), Vec3f(0, size, 0)})
      piece.positions.push_back(corner);
  }
  const std::vector<Triangle> large = {piece.triangles[1], piece.triangles[2]};
  EXPECT_EQ(drop_small_triangles(piece, 2).triangles, large);
}

}  // namespace
}  // namespace burnish
