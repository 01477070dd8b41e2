#include "server/session/volume_root.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace burnish {
namespace {

// (t - a)(t - b)(t - c)
Cubic with_zeros(double a, double b, double c) {
  return {-a * b * c, a * b + b * c + c * a, -(a + b + c), 1};
}

TEST(VolumeRoot, ASmallSphereGrowsToItsFormerRadiusHoweverSmallItIs) {
  for (const double radius : {0.999, 0.5, 0.2, 1e-3, 1e-9}) {
    const Cubic missing = {radius * radius * radius - 1, 3 * radius * radius, 3 * radius, 1};
    EXPECT_NEAR(first_zero(missing, 2), 1 - radius, 1e-14) << radius;
  }
}

TEST(VolumeRoot, TooMuchIsTakenAway) {
  EXPECT_NEAR(first_zero({1.1 * 1.1 * 1.1 - 1, 3 * 1.1 * 1.1, 3.3, 1}, 2), -0.1, 1e-14);
}

TEST(VolumeRoot, ACurveHasItsZeroOnEitherSideWhateverIsGuessed) {
  for (const double zero : {-3.0, -0.01, 0.0, 0.4, 7.0})
    for (const double guess : {-5.0, 0.0, 1e-7, 0.4, 50.0}) {
      int steps = 0;
      const auto curve = [&](double t) {
        ++steps;
        return std::tanh(5 * (t - zero)) + 0.01 * (t - zero);
      };
      EXPECT_NEAR(curve_zero(curve, {.guess = guess, .limit = 10, .tolerance = 1e-9}), zero, 1e-8)
          << zero << " " << guess;
      EXPECT_LE(steps, 41);
    }
}

TEST(VolumeRoot, ACurveWithoutAZeroGivesItsNearestPlace) {
  const auto saturates = [](double t) { return std::min(t, 2.0) - 3; };
  EXPECT_NEAR(curve_zero(saturates, {.guess = 2, .limit = 10, .tolerance = 1e-6}), 2, 1e-6);
  EXPECT_EQ(curve_zero(saturates, {.guess = 2, .limit = 0, .tolerance = 1e-6}), 0);
}

TEST(VolumeRoot, TheFirstZeroOnTheWayCounts) {
  EXPECT_NEAR(first_zero(with_zeros(1, 2, 3), 10), 1, 1e-14);
  EXPECT_NEAR(first_zero(with_zeros(-1, 2, 3), 10), -1, 1e-14);
  EXPECT_NEAR(first_zero(with_zeros(-2, -1, 3), 10), 3, 1e-13);
}

TEST(VolumeRoot, WithoutAZeroTheNearestValueCounts) {
  const Cubic two_turns = {-1.5, 3, -1.5, 0};  // a parabola with its top, 0.0, at 1
  EXPECT_NEAR(first_zero(two_turns, 10), 1, 1e-7);
  EXPECT_NEAR(first_zero({-2, 2, -1, 0}, 10), 1, 1e-14);  // the top is at -1
  EXPECT_EQ(first_zero({-2, 1, 0, 0}, 0.5), 0.5);
  EXPECT_EQ(first_zero({-2, -1, 0, 0}, 0.5), 0);
}

TEST(VolumeRoot, NothingMissingOrNoWayIsNoMove) {
  EXPECT_EQ(first_zero({0, 1, 1, 1}, 5), 0);
  EXPECT_EQ(first_zero({-1, 1, 1, 1}, 0), 0);
  EXPECT_EQ(first_zero({-1, 0, 0, 0}, 5), 0);
}

TEST(VolumeRoot, FollowsTheCoefficientsWithoutAJump) {
  double last = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double radius = 1 - 0.00099 * i;
    const double t =
        first_zero({radius * radius * radius - 1, 3 * radius * radius, 3 * radius, 1}, 2);
    EXPECT_NEAR(t - last, i == 0 ? 0 : 0.00099, 1e-9);
    last = t;
  }
}

}  // namespace
}  // namespace burnish
