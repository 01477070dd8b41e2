#include "common/mesh/statistics/thin_walls.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(ThinWallsText, SaysWhatAnEditDoesAndWhichDepthHelps) {
  EXPECT_EQ(describe({0.237, 9}),
            "Walls: 24 % of the surface is thinner than a cell; an edit of one side moves the "
            "other. At depth 9, nine tenths of that is thicker than a cell.");
}

TEST(ThinWallsText, NamesNoDepthWhereNoneHelps) {
  EXPECT_EQ(describe({0.5, 0}),
            "Walls: 50 % of the surface is thinner than a cell; an edit of one side moves the "
            "other.");
}

TEST(ThinWallsText, WithoutWallsItIsEmpty) {
  EXPECT_EQ(describe({}), "");
}

}  // namespace
}  // namespace burnish
