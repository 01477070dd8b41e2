#include "common/base/ratio.h"

#include <limits>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr double kFewUnits = 100 * std::numeric_limits<double>::epsilon();

TEST(Ratio, PowersAreThoseOfTheLibrary) {
  for (const double base : {1e-6, 0.88, 1.0, 3.0, 1e6})
    for (const double exponent : {-3.0, -0.25, 0.0, 1.0, 7.0})
      EXPECT_NEAR(power(base, exponent) / std::pow(base, exponent), 1, kFewUnits);
}

TEST(Ratio, LogarithmsToBase2AreThoseOfTheLibrary) {
  for (const double number : {1e-9, 0.5, 1.0, 1000.0, 1e12})
    EXPECT_NEAR(binary_logarithm(number), std::log2(number), 64 * kFewUnits);
}

TEST(Ratio, HalfWayIsTheGeometricMean) {
  EXPECT_NEAR(between_by_ratio(4, 9, 0.5), 6, 6 * kFewUnits);
  EXPECT_EQ(between_by_ratio(4, 9, 0), 4);
  EXPECT_NEAR(between_by_ratio(4, 9, 1), 9, 9 * kFewUnits);
}

}  // namespace
}  // namespace burnish
