#include "common/page_frames/page_steps.h"

#include <limits>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

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
  for (int round = 0; round < 200; ++round) {
    const int shift = static_cast<int>(random() % 8);
    std::vector<int32_t> wanted(30), old(30);
    for (int32_t& value : wanted) value = static_cast<int32_t>(random() % (1 << 29)) - (1 << 28);
    for (int32_t& value : old) value = static_cast<int32_t>(random());
    std::vector<int32_t> coded = old, undone = old;
    std::vector<uint32_t> residuals(30);
    code_page(wanted, shift, coded, residuals);
    undo_page(residuals, shift, undone);
    EXPECT_EQ(coded, rounded(wanted, shift));
    EXPECT_EQ(undone, coded);
  }
}

TEST(PageSteps, AnEqualChangeOfAllValuesHasOneResidualAnAxis) {
  const std::vector<int32_t> wanted(9, 8);
  std::vector<int32_t> values(9, 0);
  std::vector<uint32_t> residuals(9);
  EXPECT_TRUE(code_page(wanted, 2, values, residuals));
  EXPECT_THAT(residuals, testing::ElementsAre(4, 0, 0, 4, 0, 0, 4, 0, 0));
}

TEST(PageSteps, ValuesThatAreAlreadyRoundedSoAreNoChange) {
  const std::vector<int32_t> wanted = {5, -6, 130};
  std::vector<int32_t> values = rounded(wanted, 2);
  std::vector<uint32_t> residuals(3);
  EXPECT_FALSE(code_page(wanted, 2, values, residuals));
}

TEST(PageSteps, AnotherStepIsAChangeWithoutResiduals) {
  const std::vector<int32_t> wanted = {5, -6, 130};
  std::vector<int32_t> values = wanted;
  std::vector<uint32_t> residuals(3);
  EXPECT_TRUE(code_page(wanted, 2, values, residuals));
  EXPECT_THAT(residuals, testing::Each(0u));
}

TEST(PageSteps, AnyResidualsWrapAround) {
  std::vector<int32_t> values(6, std::numeric_limits<int32_t>::max());
  undo_page(std::vector<uint32_t>(6, ~0u), 7, values);
  EXPECT_EQ(values[0] & 127, 0);
}

}  // namespace
}  // namespace burnish
