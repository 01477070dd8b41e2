#include "common/grid/grid.h"

#include <cmath>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(GridFrame, CentresTheBoxAndItsLongestSideIsNineTenthsOfTheCube) {
  const Vec3d least(-3, 10, 100), most(1, 30, 107);
  for (int depth = kDepthMin; depth <= kDepthMax; ++depth) {
    const GridFrame frame = make_grid_frame(least, most, depth);
    const double side = frame.cells_per_side();
    EXPECT_NEAR((frame.to_grid(most) - frame.to_grid(least)).maxCoeff(), 0.9 * side, 1e-12 * side);
    const Vec3d middle = frame.to_grid((least + most) / 2);
    EXPECT_LT((middle - Vec3d::Constant(side / 2)).norm(), 1e-12 * side);
  }
}

TEST(GridFrame, ToFileUndoesToGrid) {
  const GridFrame frame = make_grid_frame({1e6, -5, 0}, {1e6 + 3, 8, 2}, 9);
  const Vec3d p(1e6 + 1.25, 0.7, 1.9);
  EXPECT_LT((frame.to_file(frame.to_grid(p)) - p).norm(), 1e-9);
}

TEST(GridFrame, TakesABoxThatIsFlatOrALine) {
  const GridFrame flat = make_grid_frame({0, 0, 5}, {2, 1, 5}, 4);
  EXPECT_DOUBLE_EQ(flat.to_grid({1, 0.5, 5}).z(), 8);
  const GridFrame line = make_grid_frame({0, 1, 2}, {0, 4, 2}, 4);
  EXPECT_NEAR(line.cell_size, 3 / 0.9 / 16, 1e-15);
}

TEST(MatchingDepth, MakesACellAboutOneAndAHalfMeanEdges) {
  const Vec3d least(0, 0, 0), most(0.9, 0.5, 0.1);  // the cube's side is 1
  for (int depth = kDepthMin; depth <= kDepthMax; ++depth) {
    const double cell = std::ldexp(1.0, -depth);
    EXPECT_EQ(matching_depth(least, most, cell / 1.5), depth);
    EXPECT_EQ(matching_depth(least, most, cell / 1.5 * 1.35), depth);
    EXPECT_EQ(matching_depth(least, most, cell / 1.5 * 0.75), depth);
  }
}

TEST(MatchingDepth, StaysWithinItsLimitsForAnyEdgeLength) {
  const Vec3d least(0, 0, 0), most(1, 1, 1);
  EXPECT_EQ(matching_depth(least, most, 5), kDepthMin);
  EXPECT_EQ(matching_depth(least, most, 1e-9), kDepthMax);
  EXPECT_EQ(matching_depth(least, most, 0), kDepthMax);
  EXPECT_EQ(matching_depth(least, least, 0), kDepthMin);
}

TEST(SnapToPlanes, RoundsOnlyWhatIsWithinATenMillionthOfACell) {
  EXPECT_EQ(snap_to_planes({3 - 9e-8, 3 + 9e-8, 7}), Vec3d(3, 3, 7));
  const Vec3d apart(3 - 1.1e-7, 3 + 1.1e-7, 2.5);
  EXPECT_EQ(snap_to_planes(apart), apart);
}

}  // namespace
}  // namespace burnish
