#include <limits>

#include <gtest/gtest.h>

#include "server/solver/cycle/backend.h"

namespace burnish {
namespace {

// A first step along a correction that solves nearly all.
Measures good_step() {
  Measures measures;
  measures.energy = -50;
  measures.residual = 0.1;
  measures.preconditioned_residual = 100;
  measures.moved_max = 3;
  measures.curvature = 20;
  measures.direction_energy = 100;
  measures.is_first_direction = true;
  return measures;
}

TEST(Measures, OfAGoodStepAreSound) {
  EXPECT_TRUE(good_step().is_sound());
}

TEST(Measures, ThatAreNotFiniteAreNotSound) {
  Measures measures = good_step();
  measures.energy = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(measures.is_sound());
}

TEST(Measures, OfACorrectionThatIsMostlyErrorAreNotSound) {
  Measures measures = good_step();
  measures.direction_energy = 1e8;
  EXPECT_FALSE(measures.is_sound());
  measures.is_first_direction = false;
  EXPECT_TRUE(measures.is_sound());
}

TEST(Measures, OfACorrectionThatLeadsUphillAreNotSound) {
  Measures measures = good_step();
  measures.preconditioned_residual = -100;
  EXPECT_FALSE(measures.is_sound());
}

// Where nothing is left to do, the numbers are rounding.
TEST(Measures, OfASolvedSystemAreSound) {
  Measures measures = good_step();
  measures.residual = 1e-12;
  measures.preconditioned_residual = -1e-20;
  EXPECT_TRUE(measures.is_sound());
  EXPECT_TRUE(Measures().is_sound());
}

}  // namespace
}  // namespace burnish
