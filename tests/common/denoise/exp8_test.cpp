#include "common/denoise/exp8.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

float exp_of(float x) {
  exp_in_place(&x, 1);
  return x;
}

TEST(Exp8, IsWithinItsBoundOfTheValue) {
  for (float x = 0; x > kExponentMin; x -= 0.0037f)
    ASSERT_NEAR(exp_of(x) / std::exp(double{x}), 1, 3e-7) << x;
}

TEST(Exp8, FallsNoFurtherThanItsLeastExponent) {
  EXPECT_EQ(exp_of(-1e30f), exp_of(kExponentMin));
  EXPECT_EQ(exp_of(-INFINITY), exp_of(kExponentMin));
  EXPECT_EQ(exp_of(0), 1);
}

TEST(Exp8, AValueIsTheSameAtEachPositionOfARow) {
  std::vector<float> row(21, -1.25f);
  exp_in_place(row.data(), 20);
  for (size_t i = 0; i < 20; ++i) EXPECT_EQ(row[i], exp_of(-1.25f));
  EXPECT_EQ(row[20], -1.25f);
}

}  // namespace
}  // namespace burnish
