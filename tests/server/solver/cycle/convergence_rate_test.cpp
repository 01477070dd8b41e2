#include "server/solver/cycle/convergence_rate.h"

#include <cmath>
#include <initializer_list>

#include <gtest/gtest.h>

namespace burnish {
namespace {

/// Returns the estimate after `steps` steps, the last of length 1. Lengths shrink by `lengths`,
/// errors in the energy norm by `errors`; rᵀz shrinks by its square.
double distance_after(int steps, double lengths, double errors) {
  ConvergenceRate rate;
  for (int to_come = steps - 1; to_come >= 0; --to_come)
    rate.add({std::pow(lengths, -to_come), std::pow(errors, -2 * to_come)});
  return rate.distance();
}

// ρ + ρ² + ... = ρ/(1 − ρ).
TEST(ConvergenceRate, AddsUpTheStepsToComeByTheSlowerOfLengthsAndEnergies) {
  EXPECT_NEAR(distance_after(5, 0.8, 0.7), 4, 1e-12);
  EXPECT_NEAR(distance_after(5, 0.7, 0.8), 4, 1e-12);
  EXPECT_NEAR(distance_after(2, 0.9, 0.1), 9, 1e-12);
}

TEST(ConvergenceRate, ExpectsTwiceTheLastStepWhateverTheFirstOnesGain) {
  EXPECT_DOUBLE_EQ(distance_after(1, 1, 1), 2);
  EXPECT_DOUBLE_EQ(distance_after(2, 1e-3, 1e-3), 2);
  EXPECT_DOUBLE_EQ(distance_after(9, 0.5, 0.5), 2);
}

// 4/5 of 0.9 and 1/5 of 2/3 are 64/75.
TEST(ConvergenceRate, ForgetsSlowStepsSlowly) {
  ConvergenceRate rate;
  for (double length : {1.0, 0.9, 0.09}) rate.add({length, 0});
  EXPECT_NEAR(rate.distance(), 0.09 * 64 / 11, 1e-12);
  for (int i = 0; i < 60; ++i) rate.add({std::pow(0.5, i), 0});
  EXPECT_NEAR(rate.distance() / std::pow(0.5, 59), 2, 1e-4);
}

TEST(ConvergenceRate, IsCappedWhereStepsNoLongerShrink) {
  EXPECT_NEAR(distance_after(5, 1, 1), 19, 1e-12);
  EXPECT_NEAR(distance_after(5, 1.5, 1), 19, 1e-12);
}

TEST(ConvergenceRate, ExpectsNothingAfterAStepThatMovedNothing) {
  ConvergenceRate rate;
  for (double residual : {0.0, -1e-30, 0.0}) rate.add({0, residual});
  EXPECT_EQ(rate.distance(), 0);
}

TEST(ConvergenceRate, ForgetsAtARestart) {
  ConvergenceRate rate;
  for (double length : {1.0, 0.9, 0.8}) rate.add({length, length * length});
  rate.restart();
  rate.add({1, 1});
  EXPECT_DOUBLE_EQ(rate.distance(), 2);
}

}  // namespace
}  // namespace burnish
