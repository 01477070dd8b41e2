#include "server/solver/convergence_rate.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

/// After `steps` steps of which each leaves `factor` of the error; rᵀz goes by its square.
double estimate_after(int steps, double factor) {
  ConvergenceRate rate;
  double preconditioned_residual = 1;
  for (int i = 0; i < steps; ++i, preconditioned_residual *= factor * factor)
    rate.add(preconditioned_residual);
  return rate.error_over_correction();
}

// κ = ((1 + ρ) / (1 − ρ))².
TEST(ConvergenceRate, TakesTheSlowestErrorThatTheLastStepsAllow) {
  EXPECT_NEAR(estimate_after(5, 0.5), 9, 1e-12);
  EXPECT_NEAR(estimate_after(30, 0.8), 81, 1e-10);
}

TEST(ConvergenceRate, GuessesAHalfBeforeThreeSteps) {
  EXPECT_EQ(estimate_after(1, 0.8), 9);
  EXPECT_EQ(estimate_after(2, 0.1), 9);
}

TEST(ConvergenceRate, IsCappedWhereStepsLeaveMoreThanNineTenths) {
  EXPECT_EQ(estimate_after(5, 0.99), estimate_after(5, 0.9));
}

TEST(ConvergenceRate, ForgetsAtARestart) {
  ConvergenceRate rate;
  for (double residual : {1.0, 0.9, 0.8, 0.7}) rate.add(residual);
  rate.restart();
  EXPECT_EQ(rate.error_over_correction(), 9);
}

}  // namespace
}  // namespace burnish
