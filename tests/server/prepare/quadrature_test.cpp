#include "server/prepare/quadrature.h"

#include <cmath>
#include <span>

#include <gtest/gtest.h>

namespace burnish {
namespace {

double factorial(int n) {
  return n < 2 ? 1 : n * factorial(n - 1);
}

// The mean of aᵖ bᵠ cʳ over a triangle is 2 p! q! r! / (p + q + r + 2)!.
double mean_of_monomial(int p, int q, int r) {
  return 2 * factorial(p) * factorial(q) * factorial(r) / factorial(p + q + r + 2);
}

double worst_error(std::span<const QuadraturePoint> rule, int degree) {
  double worst = 0;
  for (int p = 0; p <= degree; ++p) {
    for (int q = 0; p + q <= degree; ++q) {
      for (int r = 0; p + q + r <= degree; ++r) {
        double sum = 0;
        for (const QuadraturePoint& x : rule)
          sum += x.weight * std::pow(x.a, p) * std::pow(x.b, q) * std::pow(x.c, r);
        worst = std::max(worst, std::abs(sum - mean_of_monomial(p, q, r)));
      }
    }
  }
  return worst;
}

void expect_barycentric(std::span<const QuadraturePoint> rule) {
  double sum = 0;
  for (const QuadraturePoint& x : rule) {
    EXPECT_NEAR(x.a + x.b + x.c, 1, 1e-14);
    EXPECT_TRUE(x.a > 0 && x.b > 0 && x.c > 0 && x.weight > 0);
    sum += x.weight;
  }
  EXPECT_NEAR(sum, 1, 1e-13);
}

TEST(Quadrature, WeightsSumToOneAndPointsLieInside) {
  expect_barycentric(kDegree6Rule);
}

TEST(Quadrature, OfDegreeSixIsExactForEveryMonomialUpToThatDegree) {
  EXPECT_LT(worst_error(kDegree6Rule, 6), 1e-13);
  EXPECT_GT(worst_error(kDegree6Rule, 7), 1e-7);
}

}  // namespace
}  // namespace burnish
