#include "client/raster/shade_math.h"

#include <cmath>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(ShadeMath, PowersAreWithinAFewStepsOfFloats) {
  for (const float exponent : {1 / 2.2f, 2.2f, 1.6f})
    for (float base = 1e-6f; base < 4; base *= 1.01f) {
      const float expected = std::pow(base, exponent);
      EXPECT_NEAR(power(base, exponent), expected, 4e-6f * expected) << base << " " << exponent;
    }
}

TEST(ShadeMath, APowerOfNothingIsAsGoodAsNothing) {
  EXPECT_LT(power(0, 1 / 2.2f), 1e-9f);
  EXPECT_LT(power(0, 2.2f), 1e-9f);
}

TEST(ShadeMath, SmoothStepRunsFromNothingToAll) {
  EXPECT_EQ(smooth_step(1, 3, 0), 0);
  EXPECT_EQ(smooth_step(1, 3, 2), 0.5f);
  EXPECT_EQ(smooth_step(1, 3, 4), 1);
}

}  // namespace
}  // namespace burnish
