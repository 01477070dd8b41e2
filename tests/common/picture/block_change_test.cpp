#include "common/picture/block_change.h"

#include <cmath>

#include <gtest/gtest.h>

namespace burnish {
namespace {

std::array<uint16_t, 64> steps_of(uint16_t step) {
  std::array<uint16_t, 64> steps;
  steps.fill(step);
  return steps;
}

TEST(BlockChange, AnEvenChangeIsOneOfTheMean) {
  Block8 samples;
  samples.fill(6);
  std::array<int16_t, 64> coefficients = {};
  coefficients[0] = -10;
  coefficients[9] = 7;
  std::array<int16_t, 64> expected = coefficients;
  expected[0] = -10 + 6 * 8 / 4;
  add_to_block(samples, steps_of(4), coefficients);
  EXPECT_EQ(coefficients, expected);
}

TEST(BlockChange, ARisingChangeDownIsAtTheSecondCoefficientOfTheFirstColumn) {
  Block8 samples;
  for (size_t i = 0; i < 64; ++i)
    samples[i] =
        20 * static_cast<float>(std::cos((2.0 * static_cast<double>(i / 8) + 1) * M_PI / 16));
  std::array<int16_t, 64> coefficients = {}, expected = {};
  expected[8] = static_cast<int16_t>(std::lround(20 * 4 * std::sqrt(2.0)));
  add_to_block(samples, steps_of(1), coefficients);
  EXPECT_EQ(coefficients, expected);
}

TEST(BlockChange, AChangeBelowHalfAStepIsNone) {
  Block8 samples;
  samples.fill(1);
  std::array<int16_t, 64> coefficients = {5, 4, 3};
  const auto before = coefficients;
  add_to_block(samples, steps_of(17), coefficients);
  EXPECT_EQ(coefficients, before);
}

TEST(BlockChange, AStepOfZeroKeepsTheCoefficients) {
  Block8 samples;
  samples.fill(200);
  std::array<int16_t, 64> coefficients = {5, 4, 3};
  const auto before = coefficients;
  add_to_block(samples, steps_of(0), coefficients);
  EXPECT_EQ(coefficients, before);
}

TEST(BlockChange, CoefficientsStayWithinHuffmanCodes) {
  Block8 samples;
  samples.fill(255);
  std::array<int16_t, 64> coefficients = {1000};
  add_to_block(samples, steps_of(1), coefficients);
  EXPECT_EQ(coefficients[0], 1023);
}

}  // namespace
}  // namespace burnish
