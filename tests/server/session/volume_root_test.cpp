#include "server/session/volume_root.h"

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
