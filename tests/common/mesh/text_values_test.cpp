#include "common/mesh/reading/text_values.h"

#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace burnish {
namespace {

std::string printed(const char* format, int precision, double value) {
  char text[200];
  std::snprintf(text, sizeof text, format, precision, value);
  return text;
}

bool text_exceeds_float(const std::string& text) {
  double value = 0;
  EXPECT_TRUE(parse_double(text, value)) << text;
  return exceeds_float(text, value);
}

TEST(TextValues, WhatIsPrintedFromAFloatNeverExceedsIt) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> mantissa(-10, 10);
  std::uniform_int_distribution<int> exponent(-12, 12);
  for (int i = 0; i < 20'000; ++i) {
    const float value = std::ldexp(mantissa(random), exponent(random));
    const int precision = i % 17 + 1;
    for (const char* format : {"%.*g", "%.*f", "%.*e"}) {
      const std::string text = printed(format, precision, value);
      EXPECT_FALSE(text_exceeds_float(text)) << text;
    }
    EXPECT_FALSE(text_exceeds_float(number_text(value))) << number_text(value);
  }
}

TEST(TextValues, WhatIsPrintedInFullFromADoubleExceedsAFloat) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mantissa(1, 10);
  for (int i = 0; i < 20'000; ++i) {
    const std::string text = printed("%.*g", 15, mantissa(random) * std::pow(10, i % 24 - 12));
    EXPECT_TRUE(text_exceeds_float(text)) << text;
  }
}

TEST(TextValues, NumbersAreWholeTokens) {
  double value = 0;
  int64_t integer = 0;
  EXPECT_TRUE(parse_double("+1.5e3", value));
  EXPECT_EQ(value, 1500);
  EXPECT_TRUE(parse_integer("+7", integer));
  EXPECT_EQ(integer, 7);
  for (const char* text : {"", "+", "-", "+-1", "1.5x", "0x10", "1,5", "--1", " 1"}) {
    EXPECT_FALSE(parse_double(text, value)) << text;
    EXPECT_FALSE(parse_integer(text, integer)) << text;
  }
  EXPECT_FALSE(parse_integer("9223372036854775808", integer));
}

TEST(TextValues, QuotesAreShortAndPrintable) {
  EXPECT_EQ(in_quotes("a\nb\x80"), "'a?b?'");
  EXPECT_EQ(in_quotes(std::string(1000, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(TextValues, WholeNumbersShowAllTheirDigits) {
  EXPECT_EQ(integer_text(4e9), "4000000000");
  EXPECT_EQ(integer_text(-3), "-3");
  EXPECT_EQ(integer_text(9223372036854775808.0), "9223372036854775808");
}

}  // namespace
}  // namespace burnish
