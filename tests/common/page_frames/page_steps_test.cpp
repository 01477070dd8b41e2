#include "common/page_frames/page_steps.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

PageLayout plain_layout(uint32_t values) {
  return *plain_page(0, values).layout;
}

/// Four values; the last is predicted by the first three.
PageLayout fan_layout() {
  Page page;
  page.positions.resize(4);
  page.triangles = {{0, 1, 3}, {1, 2, 3}};
  return make_vertex_page_layout(page);
}

TEST(PageSteps, RoundToTheNearestAndHalvesUp) {
  EXPECT_EQ(round_to_step(5, 0), 5);
  EXPECT_EQ(round_to_step(5, 2), 1);
  EXPECT_EQ(round_to_step(6, 2), 2);
  EXPECT_EQ(round_to_step(-5, 2), -1);
  EXPECT_EQ(round_to_step(-6, 2), -1);
  EXPECT_EQ(round_to_step(-7, 2), -2);
}

TEST(PageSteps, NewValuesAreTheRoundedWantedOnesWhateverTheOldOnes) {
  std::mt19937 random(5);
  const PageLayout layout = fan_layout();
  for (int round = 0; round < 200; ++round) {
    const int shift = static_cast<int>(random() % 8);
    std::vector<int32_t> wanted(12), old(12);
    for (int32_t& value : wanted) value = static_cast<int32_t>(random() % (1 << 29)) - (1 << 28);
    for (int32_t& value : old) value = static_cast<int32_t>(random());
    std::vector<int32_t> coded = old, undone = old;
    std::vector<uint32_t> residuals(12);
    code_page(layout, wanted, shift, coded, residuals);
    undo_page(layout, residuals, shift, undone);
    EXPECT_EQ(coded, rounded(wanted, shift));
    EXPECT_EQ(undone, coded);
  }
}

TEST(PageSteps, AnEqualChangeOfAllValuesHasOneResidualAnAxis) {
  const std::vector<int32_t> wanted(9, 8);
  std::vector<int32_t> values(9, 0);
  std::vector<uint32_t> residuals(9);
  EXPECT_TRUE(code_page(plain_layout(3), wanted, 2, values, residuals));
  EXPECT_THAT(residuals, testing::ElementsAre(4, 0, 0, 4, 0, 0, 4, 0, 0));
}

TEST(PageSteps, TheMeanOfAllPredictorsPredictsAndHalvesGoUp) {
  std::vector<int32_t> wanted(12, 0);
  const std::vector<int32_t> x = {1, 2, 4, 2}, y = {-1, -2, -4, -2}, z = {3, 5, -7, 0};
  std::ranges::copy(x, wanted.begin());
  std::ranges::copy(y, wanted.begin() + 4);
  std::ranges::copy(z, wanted.begin() + 8);
  std::vector<int32_t> values(12, 0);
  std::vector<uint32_t> residuals(12);
  code_page(fan_layout(), wanted, 0, values, residuals);
  EXPECT_EQ(residuals[3], 0u);   // 2 of 7/3
  EXPECT_EQ(residuals[7], 0u);   // -2 of -7/3
  EXPECT_EQ(residuals[11], 0u);  // 0 of 1/3
}

TEST(PageSteps, ValuesThatAreAlreadyRoundedSoAreNoChange) {
  const std::vector<int32_t> wanted = {5, -6, 130};
  std::vector<int32_t> values = rounded(wanted, 2);
  std::vector<uint32_t> residuals(3);
  EXPECT_FALSE(code_page(plain_layout(1), wanted, 2, values, residuals));
}

TEST(PageSteps, AnotherStepIsAChangeWithoutResiduals) {
  const std::vector<int32_t> wanted = {5, -6, 130};
  std::vector<int32_t> values = wanted;
  std::vector<uint32_t> residuals(3);
  EXPECT_TRUE(code_page(plain_layout(1), wanted, 2, values, residuals));
  EXPECT_THAT(residuals, testing::Each(0u));
}

TEST(PageSteps, AnyResidualsWrapAround) {
  std::vector<int32_t> values(6, std::numeric_limits<int32_t>::max());
  undo_page(plain_layout(2), std::vector<uint32_t>(6, ~0u), 7, values);
  EXPECT_EQ(values[0] & 127, 0);
}

}  // namespace
}  // namespace burnish
