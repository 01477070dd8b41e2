#include "client/model/depth_choice.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "common/grid/depth_plan.h"

namespace burnish {
namespace {

using testing::HasSubstr;

MeshStatistics tablet() {
  MeshStatistics scan;
  scan.box_max = {90, 90, 9};  // 100 mm for 2^depth cells
  scan.area = 2 * 90 * 90;
  scan.mean_edge_length = 0.26;
  return scan;
}

const DepthChoice& at(const std::vector<DepthChoice>& choices, int depth) {
  return choices.at(static_cast<size_t>(depth - kDepthMin));
}

TEST(DepthChoice, EveryDepthTellsDetailsCellsAndMemory) {
  const auto choices = depth_choices(tablet(), "mm", 0);
  ASSERT_EQ(choices.size(), size_t{kDepthMax - kDepthMin + 1});
  EXPECT_THAT(at(choices, 9).text, HasSubstr("depth 9"));
  EXPECT_THAT(at(choices, 9).text, HasSubstr("from 0.391 mm"));
  EXPECT_THAT(at(choices, 9).text, HasSubstr("cells of 0.195 mm"));
  EXPECT_NEAR(plan_depth(tablet(), 9).memory_bytes, 1.75e9, 0.05e9);
  EXPECT_THAT(at(choices, 9).text, HasSubstr("about 1.8 GB"));
  EXPECT_THAT(edges_text(tablet(), "mm"), HasSubstr("0.26 mm"));
}

TEST(DepthChoice, OneDepthIsTheDefault) {
  const auto choices = depth_choices(tablet(), "", 0);
  EXPECT_EQ(std::count_if(choices.begin(), choices.end(),
                          [](const DepthChoice& choice) { return choice.is_default; }),
            1);
  EXPECT_TRUE(at(choices, 8).is_default);  // cells of 0.39, that is 1.5 edges
}

TEST(DepthChoice, ADepthThatCannotFitIsRefusedWithBothAmounts) {
  const auto choices = depth_choices(tablet(), "mm", 2'000'000'000);
  EXPECT_EQ(at(choices, 9).refusal, "");
  EXPECT_THAT(at(choices, 10).refusal, HasSubstr("7 GB"));
  EXPECT_THAT(at(choices, 10).refusal, HasSubstr("2 GB"));
}

TEST(DepthChoice, AllDepthsFitAServerOfUnknownMemory) {
  for (const DepthChoice& choice : depth_choices(tablet(), "mm", 0)) EXPECT_EQ(choice.refusal, "");
}

}  // namespace
}  // namespace burnish
