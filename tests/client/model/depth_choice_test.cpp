#include "client/model/documents/depth_choice.h"

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
  const auto choices = depth_choices(tablet(), "mm", 0, 8);
  ASSERT_EQ(choices.size(), size_t{kDepthMax - kDepthMin + 1});
  EXPECT_THAT(at(choices, 9).text, HasSubstr("depth 9"));
  EXPECT_THAT(at(choices, 9).text, HasSubstr("from 0.391 mm"));
  EXPECT_THAT(at(choices, 9).text, HasSubstr("cells of 0.195 mm"));
  EXPECT_NEAR(plan_depth(tablet(), 9).memory_bytes, 1.25e9, 0.05e9);
  EXPECT_THAT(at(choices, 9).text, HasSubstr("about 1.2 GB"));
}

TEST(DepthChoice, OneDepthIsTheDefault) {
  const auto choices = depth_choices(tablet(), "", 0, 7);
  EXPECT_TRUE(at(choices, 7).is_default);
  EXPECT_EQ(std::count_if(choices.begin(), choices.end(),
                          [](const DepthChoice& choice) { return choice.is_default; }),
            1);
}

TEST(DepthChoice, TheDefaultOfAnUnknownScanIsTheServersRule) {
  EXPECT_TRUE(at(depth_choices(tablet(), "", 0, 0), 8).is_default);  // 1.5 edges are 0.39
  const auto memory = static_cast<uint64_t>(2.1 * plan_depth(tablet(), 6).memory_bytes);
  EXPECT_TRUE(at(depth_choices(tablet(), "", memory, 0), 6).is_default);
}

TEST(DepthChoice, ADepthThatCannotFitIsRefusedWithBothAmounts) {
  const auto choices = depth_choices(tablet(), "mm", 2'000'000'000, 8);
  EXPECT_EQ(at(choices, 9).refusal, "");
  EXPECT_THAT(at(choices, 10).refusal, HasSubstr("5 GB"));
  EXPECT_THAT(at(choices, 10).refusal, HasSubstr("2 GB"));
}

TEST(DepthChoice, AllDepthsFitAServerOfUnknownMemory) {
  for (const DepthChoice& choice : depth_choices(tablet(), "mm", 0, 8))
    EXPECT_EQ(choice.refusal, "");
}

}  // namespace
}  // namespace burnish
