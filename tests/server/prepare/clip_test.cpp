#include "server/prepare/clip.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace burnish {
namespace {

using Corners = std::array<Vec3d, 3>;
using CellKey = std::array<int, 3>;

double area_of(const Polygon& polygon) {
  double area = 0;
  for (int i = 2; i < polygon.count; ++i)
    area += (polygon.vertices[i - 1] - polygon.vertices[0])
                .cross(polygon.vertices[i] - polygon.vertices[0])
                .norm() /
            2;
  return area;
}

Polygon polygon_of(const Corners& corners) {
  Polygon polygon;
  for (const Vec3d& p : corners) polygon.push(p);
  return polygon;
}

std::multiset<CellKey> cells_of(const Corners& triangle) {
  std::multiset<CellKey> cells;
  std::vector<CellColumn> columns;
  find_columns(triangle, columns);
  for (const auto& [i, j, range] : columns)
    for (int k = range.first; k <= range.last; ++k) cells.insert({i, j, k});
  return cells;
}

// Checks that each cell occurs once, each piece lies in its cell, and the pieces fill the triangle.
void expect_pieces_fill(const Corners& triangle) {
  const auto cells = cells_of(triangle);
  double area = 0;
  for (const CellKey& key : cells) {
    ASSERT_EQ(cells.count(key), 1u);
    const Polygon piece = clip_to_cell(triangle, {key[0], key[1], key[2]});
    for (int i = 0; i < piece.count; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_GE(piece.vertices[i][axis], key[axis]);
        ASSERT_LE(piece.vertices[i][axis], key[axis] + 1);
      }
    }
    area += area_of(piece);
  }
  const double whole = area_of(polygon_of(triangle));
  EXPECT_NEAR(area, whole, 1e-12 * whole + 1e-14);
}

TEST(TriangleCells, PiecesFillTheTriangle) {
  std::mt19937 random(2);
  const auto next = [&](double size) { return 4 + size * (random() / 4294967296.0 - 0.5); };
  for (double size : {0.01, 0.7, 3.0, 8.0})
    for (int i = 0; i < 200; ++i) {
      Corners triangle;
      for (Vec3d& p : triangle) p = Vec3d(next(size), next(size), next(size));
      expect_pieces_fill(triangle);
    }
}

TEST(TriangleCells, PiecesFillTrianglesWithVerticesOnPlanes) {
  std::mt19937 random(4);
  const auto next = [&] { return static_cast<double>(random() % 13) / 2; };
  for (int i = 0; i < 2000; ++i) {
    const Corners triangle = {Vec3d(next(), next(), next()), Vec3d(next(), next(), next()),
                              Vec3d(next(), next(), next())};
    if (area_of(polygon_of(triangle)) > 0) expect_pieces_fill(triangle);
  }
}

TEST(TriangleCells, OfATriangleInAGridPlaneAreTheOnesAbove) {
  for (int axis = 0; axis < 3; ++axis) {
    Corners triangle = {Vec3d(0.2, 0.2, 0.2), Vec3d(0.2, 0.2, 0.2), Vec3d(0.2, 0.2, 0.2)};
    triangle[1][(axis + 1) % 3] = 0.8;
    triangle[2][(axis + 2) % 3] = 0.8;
    for (Vec3d& p : triangle) p[axis] = 3;
    CellKey above = {0, 0, 0};
    above[axis] = 3;
    EXPECT_EQ(cells_of(triangle), (std::multiset<CellKey>{above}));
  }
}

TEST(TriangleCells, OfATriangleThatOnlyTouchesAPlaneLieOnItsOwnSide) {
  const Corners below = {Vec3d(0.5, 0.1, 0.1), Vec3d(1, 0.2, 0.1), Vec3d(1, 0.1, 0.5)};
  const Corners above = {Vec3d(1.5, 0.1, 0.1), Vec3d(1, 0.2, 0.1), Vec3d(1, 0.1, 0.5)};
  EXPECT_EQ(cells_of(below), (std::multiset<CellKey>{{0, 0, 0}}));
  EXPECT_EQ(cells_of(above), (std::multiset<CellKey>{{1, 0, 0}}));
}

TEST(TriangleCells, OfALargeTriangleAreOnlyThoseItMeets) {
  const Corners large = {Vec3d(0.3, 0.2, 0.1), Vec3d(900.7, 0.4, 450.2), Vec3d(1.1, 850.6, 430.9)};
  const auto cells = cells_of(large);
  EXPECT_GT(cells.size(), 380'000u);  // at least the shadow of the triangle on the floor
  EXPECT_LT(cells.size(), 1'600'000u);
  for (const CellKey& key : {CellKey{0, 0, 0}, CellKey{900, 0, 450}, CellKey{1, 850, 430}})
    EXPECT_EQ(cells.count(key), 1u);
}

TEST(Clip, KeepsThePartOnTheAskedSide) {
  const Polygon square = [] {
    Polygon p;
    for (const Vec3d& v : {Vec3d(0, 0, 0), Vec3d(2, 0, 0), Vec3d(2, 2, 0), Vec3d(0, 2, 0)})
      p.push(v);
    return p;
  }();
  EXPECT_DOUBLE_EQ(area_of(clip(square, 0, 0.5, 1)), 3);
  EXPECT_DOUBLE_EQ(area_of(clip(square, 0, 0.5, -1)), 1);
  EXPECT_DOUBLE_EQ(area_of(clip(square, 2, 0, 1)), 4);  // in the plane: stays
  EXPECT_EQ(clip(square, 1, 3, 1).count, 0);
  EXPECT_DOUBLE_EQ(area_of(clip_to_slab(square, 1, 1)), 2);
}

TEST(SlabRange, CountsSlabsMetWithMoreThanATouch) {
  const auto slabs = [](double low, double high) {
    const SlabRange range =
        slabs_of(polygon_of({Vec3d(low, 0, 0), Vec3d(high, 0, 0), Vec3d(low, 1, 0)}), 0);
    return std::pair(range.first, range.last);
  };
  EXPECT_EQ(slabs(0.2, 0.8), std::pair(0, 0));
  EXPECT_EQ(slabs(0.2, 3.1), std::pair(0, 3));
  EXPECT_EQ(slabs(1, 3), std::pair(1, 2));
  EXPECT_EQ(slabs(2, 2), std::pair(2, 2));
  EXPECT_EQ(slabs(1.5, 2), std::pair(1, 1));
}

}  // namespace
}  // namespace burnish
