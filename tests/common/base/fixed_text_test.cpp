#include "common/base/fixed_text.h"

#include <limits>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(FixedText, HasSoManyDigitsAndAllBeforeThePoint) {
  EXPECT_EQ(fixed_text(1513.7, 3), "1514");
  EXPECT_EQ(fixed_text(-4389.236, 5), "-4389.2");
  EXPECT_EQ(fixed_text(0.0123456, 3), "0.0123");
  EXPECT_EQ(fixed_text(0.0000456, 3), "0.0000456");
  EXPECT_EQ(fixed_text(9.999, 3), "10");
  EXPECT_EQ(fixed_text(100, 3), "100");
  EXPECT_EQ(fixed_text(2, 5), "2");
  EXPECT_EQ(fixed_text(0, 3), "0");
}

TEST(FixedText, HasAnExponentWhereDigitsWouldBeMany) {
  EXPECT_EQ(fixed_text(3.1e-7, 3), "3.1e-07");
  EXPECT_EQ(fixed_text(2e12, 3), "2e+12");
  EXPECT_EQ(fixed_text(std::numeric_limits<double>::infinity(), 3), "inf");
}

}  // namespace
}  // namespace burnish
