#include "client/gl/chart_order.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(ChartOrder, SortsThePatchesOneByOne) {
  PageTexture texture;
  texture.chart_of_triangle = {2, 0, 2, 1, 1, 1, 0};
  texture.patch_ends = {4, 7};
  const ChartOrder order = chart_order(texture);
  EXPECT_EQ(order.triangles, (std::vector<uint16_t>{1, 3, 0, 2, 6, 4, 5}));
  const std::vector<ChartRun> runs = {{0, 1, 0}, {1, 1, 1}, {2, 2, 2}, {4, 1, 0}, {5, 2, 1}};
  EXPECT_EQ(order.runs, runs);
}

TEST(ChartOrder, OneChartOfTwoPatchesIsTwoRuns) {
  PageTexture texture;
  texture.chart_of_triangle = {0, 0, 0};
  texture.patch_ends = {1, 3};
  EXPECT_EQ(chart_order(texture).runs, (std::vector<ChartRun>{{0, 1, 0}, {1, 2, 0}}));
}

}  // namespace
}  // namespace burnish
