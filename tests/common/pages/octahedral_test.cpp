#include "common/pages/octahedral.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace burnish {
namespace {

Vec3f random_direction(std::mt19937& random) {
  std::normal_distribution<float> part;
  return Vec3f(part(random), part(random), part(random)).normalized();
}

double degrees_between(const Vec3f& a, const Vec3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI;
}

TEST(Octahedral, RoundingTurnsByAThirdOfADegreeOnAverage) {
  std::mt19937 random(1);
  double sum = 0;
  double largest = 0;
  constexpr int kRuns = 100'000;
  for (int run = 0; run < kRuns; ++run) {
    const Vec3f direction = random_direction(random);
    const double turn = degrees_between(direction, octahedral_normal(octahedral_code(direction)));
    sum += turn;
    largest = std::max(largest, turn);
  }
  EXPECT_LT(sum / kRuns, 0.35);
  EXPECT_LT(largest, 1.0);
}

TEST(Octahedral, AxesAreExact) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      const Vec3f direction = sign * Vec3f::Unit(axis);
      EXPECT_EQ(octahedral_normal(octahedral_code(direction)), direction);
    }
}

TEST(Octahedral, ALargerLimitTurnsLess) {
  std::mt19937 random(3);
  for (int run = 0; run < 1000; ++run) {
    const Vec3f direction = random_direction(random);
    const OctahedralCode code = octahedral_code(direction, 32767);
    EXPECT_LT(degrees_between(direction, octahedral_normal(code, 32767)), 0.005);
  }
}

TEST(Octahedral, EveryCodeIsAUnitVector) {
  for (int u = -128; u < 128; ++u)
    for (int v = -128; v < 128; ++v) EXPECT_NEAR(octahedral_normal({u, v}).norm(), 1, 1e-6);
}

TEST(Octahedral, PredictionsAreNearForSumsOfAnySize) {
  std::mt19937 random(2);
  for (const double size : {1e2, 1e5, 1e10, 2e18})
    for (int run = 0; run < 1000; ++run) {
      const Vec3d sum = random_direction(random).cast<double>() * size;
      const OctahedralCode code =
          predicted_code({static_cast<int64_t>(sum.x()), static_cast<int64_t>(sum.y()),
                          static_cast<int64_t>(sum.z())});
      const double turn = degrees_between(sum.normalized().cast<float>(), octahedral_normal(code));
      EXPECT_LT(turn, 2.5) << size;
    }
}

TEST(Octahedral, ASumOfZeroIsPredictedAsZ) {
  EXPECT_EQ(octahedral_normal(predicted_code({0, 0, 0})), Vec3f(0, 0, 1));
}

}  // namespace
}  // namespace burnish
