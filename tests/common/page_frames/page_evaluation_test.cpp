#include "common/page_frames/page_evaluation.h"

#include <gtest/gtest.h>

#include "common/page_frames/page_corners.h"

namespace burnish {
namespace {

constexpr int kPointBits = 10;
constexpr int kPointDepth = 4;
constexpr int kSide = 1 << (kPointBits - kPointDepth);  // steps of a cell

SparseGrid grid_of(std::vector<Vec3i> cells) {
  std::vector<MortonKey> keys;
  for (const Vec3i& cell : cells) keys.push_back(morton_key(cell));
  std::ranges::sort(keys);
  return make_finest_grid(kPointDepth, keys);
}

EvaluationPoint vertex_in(const SparseGrid& grid, const Vec3i& position) {
  Page page;
  page.positions = {position};
  return make_page_evaluation(page, kPointBits, grid, PageFrameKind::kVertices).points[0];
}

TEST(PageEvaluation, AVertexLiesInItsCell) {
  const SparseGrid grid = grid_of({{1, 2, 3}, {2, 2, 3}});
  const EvaluationPoint point = vertex_in(grid, {2 * kSide + 5, 2 * kSide, 4 * kSide - 1});
  EXPECT_EQ(point.cell, grid.find_cell({2, 2, 3}));
  EXPECT_EQ(point.local[0], 5.5F / kSide);
  EXPECT_EQ(point.local[1], 0.5F / kSide);
  EXPECT_EQ(point.local[2], 1 - 0.5F / kSide);
}

TEST(PageEvaluation, AVertexAtAPlaneTakesTheCellThatItTouches) {
  const SparseGrid grid = grid_of({{1, 2, 3}});
  const EvaluationPoint above = vertex_in(grid, {2 * kSide, 2 * kSide + 7, 3 * kSide + 7});
  EXPECT_EQ(above.cell, 0);
  EXPECT_EQ(above.local[0], 1.F);
  EXPECT_EQ(above.local[1], 7.5F / kSide);
  const EvaluationPoint below = vertex_in(grid, {1 * kSide + 7, 2 * kSide - 1, 4 * kSide});
  EXPECT_EQ(below.cell, 0);
  EXPECT_EQ(below.local[1], 0.F);
  EXPECT_EQ(below.local[2], 1.F);
}

TEST(PageEvaluation, AVertexAStepFurtherDoesNotMove) {
  const SparseGrid grid = grid_of({{1, 2, 3}});
  EXPECT_EQ(vertex_in(grid, {2 * kSide + 1, 2 * kSide, 3 * kSide}).cell, kNone);
  EXPECT_EQ(vertex_in(grid, {kSide, 2 * kSide - 2, 3 * kSide}).cell, kNone);
}

TEST(PageEvaluation, TheEdgeOfTheCubeIsNoCell) {
  const SparseGrid grid = grid_of({{0, 0, 0}});
  EXPECT_EQ(vertex_in(grid, {0, 0, 0}).cell, 0);
  EXPECT_EQ(vertex_in(grid, {0, 16 * kSide - 1, 0}).cell, kNone);
}

class CornerEvaluation : public testing::Test {
 protected:
  // Returns the displacement of the corner at `place` when each corner of the grid has its
  // coordinates.
  Vec3f at(const Vec3i& place) const {
    const PageCorners corners = make_page_corners(page_.positions, kPointBits, kPointDepth);
    const auto found = std::ranges::find(corners.places, morton_key(place));
    const PageEvaluation evaluation =
        make_page_evaluation(page_, kPointBits, grid_, PageFrameKind::kCorners);
    std::vector<Vec3f> field;
    for (const GridKey& corner : grid_.corners)
      field.push_back(morton_point(corner.place).cast<float>());
    return evaluate<Vec3f>(grid_, evaluation.points[found - corners.places.begin()], field);
  }

  SparseGrid grid_ = grid_of({{1, 2, 3}});
  Page page_;
};

TEST_F(CornerEvaluation, ACornerHasItsOwnDisplacement) {
  page_.positions = {{kSide + 1, 2 * kSide + 1, 3 * kSide + 1}};
  for (int a = 0; a < kCornersPerCell; ++a) {
    const Vec3i place = Vec3i(1, 2, 3) + corner_offset(a);
    EXPECT_EQ(at(place), place.cast<float>());
  }
}

TEST_F(CornerEvaluation, ACornerOutsideTheGridTakesItsNeighbours) {
  page_.positions = {{2 * kSide, 2 * kSide + 1, 3 * kSide + 1}};  // at a plane, in no active cell
  EXPECT_EQ(at({2, 2, 3}), Vec3f(2, 2, 3));
  EXPECT_EQ(at({3, 2, 3}), Vec3f(2, 2, 3));
  EXPECT_EQ(at({3, 3, 4}), Vec3f(2, 3, 4));
}

TEST_F(CornerEvaluation, ACornerFarFromTheGridDoesNotMove) {
  page_.positions = {{9 * kSide, 9 * kSide, 9 * kSide}};
  EXPECT_EQ(at({9, 9, 9}), Vec3f(0, 0, 0));
}

}  // namespace
}  // namespace burnish
