// Also tells when another version of meshoptimizer does not lock as Debian 12's does.
#include "server/prepare/pages/collapse_edges.h"

#include <set>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/server/prepare/pages/piece_of_mesh.h"

namespace burnish {
namespace {

constexpr int kSide = 30;  // quads of the sheet, which is flat and 1 wide

std::set<uint32_t> vertices_of(const std::vector<Triangle>& triangles) {
  std::set<uint32_t> vertices;
  for (const Triangle& t : triangles) vertices.insert(t.begin(), t.end());
  return vertices;
}

size_t count_missing_locks(const PagePiece& piece, const SimplePiece& simple) {
  const std::set<uint32_t> left = vertices_of(simple.triangles);
  size_t missing = 0;
  for (uint32_t v = 0; v < piece.locked.size(); ++v)
    missing += piece.locked[v] && !left.contains(v);
  return missing;
}

TEST(CollapseEdges, LockedVerticesOfTheBoundaryAndInsideStayWhereTheyAre) {
  const TriangleMesh sheet = make_sheet(kSide, 1, 0);
  const PagePiece piece =
      piece_of(sheet, [](const Vec3d& p) { return p.x() == 0 || std::abs(p.y() - 0.5) < 1e-9; });
  const SimplePiece simple = collapse_edges(piece, 1);
  EXPECT_EQ(count_missing_locks(piece, simple), 0u);
  EXPECT_LT(simple.triangles.size(), sheet.triangles.size() / 4);
}

TEST(CollapseEdges, EveryVertexStaysWhereAllAreLocked) {
  const TriangleMesh sheet = make_sheet(kSide, 1, 0.1);
  const PagePiece piece = piece_of(sheet, [](const Vec3d&) { return true; });
  EXPECT_EQ(collapse_edges(piece, 1).triangles, piece.triangles);
}

TEST(CollapseEdges, TheBoundaryMovesWhereNothingIsLocked) {
  const TriangleMesh sheet = make_sheet(kSide, 1, 0);
  const SimplePiece simple = collapse_edges(piece_of(sheet, [](const Vec3d&) { return false; }), 8);
  EXPECT_LE(simple.triangles.size(), 8u);
}

TEST(CollapseEdges, TheErrorIsInUnitsOfThePositions) {
  TriangleMesh bump = make_sheet(kSide, 1, 0.2);
  const auto none = [](const Vec3d&) { return false; };
  const float error = collapse_edges(piece_of(bump, none), 20).error;
  EXPECT_GT(error, 0.001);
  EXPECT_LT(error, 0.2);
  for (Vec3d& vertex : bump.vertices) vertex *= 1024;
  EXPECT_NEAR(collapse_edges(piece_of(bump, none), 20).error, 1024 * error, 0.01 * 1024 * error);
}

}  // namespace
}  // namespace burnish
