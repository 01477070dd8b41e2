#include "client/report/length_ticks.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> texts(double low, double high, double apart, const std::string& unit) {
  std::vector<std::string> texts;
  for (const LengthTick& tick : length_ticks(low, high, apart, unit)) texts.push_back(tick.text);
  return texts;
}

TEST(LengthTicks, AreRoundAndTheLastHasTheUnit) {
  EXPECT_THAT(texts(-0.3, 10, 1.5, "mm"), ElementsAre("0", "2", "4", "6", "8", "10 mm"));
  EXPECT_THAT(texts(-0.12, 0.13, 0.04, "m"), ElementsAre("-0.1", "0", "0.1 m"));
  EXPECT_THAT(texts(1400, 2600, 300, ""), ElementsAre("1500", "2000", "2500"));
}

TEST(LengthTicks, AreAsFarApartAsTheyHaveToBe) {
  for (double apart = 1e-7; apart < 1e7; apart *= 1.3) {
    const auto ticks = length_ticks(-12 * apart, 12 * apart, apart, "");
    ASSERT_GE(ticks.size(), 9u);
    for (size_t i = 1; i < ticks.size(); ++i)
      EXPECT_GE(ticks[i].at - ticks[i - 1].at, apart * (1 - 1e-9));
  }
}

TEST(LengthTicks, AreNotThereWhereNoneCanBe) {
  EXPECT_THAT(texts(0, 1, 0, ""), IsEmpty());
  EXPECT_THAT(texts(0, 1, 1e-9, ""), IsEmpty());
  EXPECT_THAT(texts(0, std::nan(""), 1, ""), IsEmpty());
  EXPECT_THAT(texts(0.1, 0.2, 1, ""), IsEmpty());
}

}  // namespace
}  // namespace burnish
