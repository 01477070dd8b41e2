#include "common/base/round_number.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(RoundNumber, IsTheLargestOneTwoOrFiveThatIsNotAbove) {
  EXPECT_EQ(round_number_below(1), 1);
  EXPECT_EQ(round_number_below(1.99), 1);
  EXPECT_EQ(round_number_below(4.9), 2);
  EXPECT_EQ(round_number_below(5), 5);
  EXPECT_EQ(round_number_below(9.99), 5);
  EXPECT_EQ(round_number_below(10), 10);
  EXPECT_EQ(round_number_below(4389.2), 2000);
  EXPECT_EQ(round_number_below(0.00731), 0.005);
  EXPECT_EQ(round_number_below(0.0199), 0.01);
}

TEST(RoundNumber, IsTheDecimalNumberItselfAndWithinTwoAndAHalfTimes) {
  EXPECT_EQ(round_number_below(0.2), 0.2);
  EXPECT_EQ(round_number_below(0.05), 0.05);
  EXPECT_EQ(round_number_below(1e-9), 1e-9);
  for (double limit = 1e-12; limit < 1e15; limit *= 1.37) {
    EXPECT_LE(round_number_below(limit), limit);
    EXPECT_GT(round_number_below(limit) * 2.5 * (1 + 1e-12), limit);
  }
}

}  // namespace
}  // namespace burnish
