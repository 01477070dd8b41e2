#include "common/mesh/rewrite/patch/text_digits.h"

#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TextDigits digits_of(std::initializer_list<const char*> coordinates) {
  TextDigits digits;
  for (const char* coordinate : coordinates) digits.add(coordinate);
  return digits;
}

TEST(TextDigits, ATextOfFixedDecimalsKeepsThem) {
  const TextDigits digits = digits_of({"499907.356", "4649907.242", "329.700", "-0.000"});
  EXPECT_EQ(digits.kept(329.73149, 329.7), 329.731);
  EXPECT_EQ(digits.text_of(329.731, 329.7, "329.700"), "329.731");
  EXPECT_EQ(digits.text_of(330, 329.7, "329.700"), "330.000");
  EXPECT_EQ(digits.kept(0.0004, 0), 0);
  EXPECT_EQ(digits.text_of(0.001, 0, "0"), "0.001");
  EXPECT_EQ(digits.text_of(1000000.001, 999999.999, "999999.999"), "1000000.001");
}

TEST(TextDigits, ATextOfANumberOfDigitsKeepsThat) {
  const TextDigits digits = digits_of({"499907.3561", "4649907.24", "0.0001234567891", "7"});
  EXPECT_EQ(digits.kept(4649907.24321, 4649907.24), 4649907.243);
  EXPECT_EQ(digits.kept(499907.35612, 499907.3561), 499907.3561);
  EXPECT_EQ(digits.text_of(7.25, 7, "7"), "7.25");
}

TEST(TextDigits, AnExponentStays) {
  const TextDigits digits = digits_of({"4.99907356E+05", "3.29731000E+02"});
  EXPECT_EQ(digits.kept(499907.35749, 499907.356), 499907.357);
  EXPECT_EQ(digits.text_of(499907.357, 499907.356, "4.99907356E+05"), "4.99907357E+05");
  const TextDigits coarse = digits_of({"1.23456789012e+13"});
  EXPECT_EQ(coarse.kept(12345678901349.0, 12345678901200.0), 12345678901300.0);
  EXPECT_EQ(coarse.text_of(12345678901300.0, 12345678901200.0, "1.23456789012e+13"),
            "1.23456789013e+13");
}

TEST(TextDigits, AllDigitsOfADoubleAreTheShortestText) {
  const TextDigits digits = digits_of({"0.10000000000000001", "512345.67800000001"});
  EXPECT_EQ(digits.kept(0.3, 0.1), 0.3);
  EXPECT_EQ(digits.text_of(512345.679, 512345.678, "512345.678"), "512345.679");
}

TEST(TextDigits, DecimalsThatAreTooCoarseGetMore) {
  TextDigits digits = digits_of({"12.345", "0.250", "3.141"});
  digits.refine(2.5e-6);
  EXPECT_EQ(digits.kept(12.345678912, 12.345), 12.345679);
  EXPECT_EQ(digits.text_of(12.345679, 12.345, "12.345"), "12.345679");
  EXPECT_EQ(digits.text_of(12.35, 12.345, "12.345"), "12.350");
  digits.refine(0.5);
  EXPECT_EQ(digits.kept(12.345678912, 12.345), 12.346);
}

TEST(TextDigits, AStepOfAPowerOfTenIsNotRefined) {
  for (int decimals = 1; decimals <= 12; ++decimals) {
    TextDigits digits = digits_of({"1"});
    digits.refine(std::stod("1e-" + std::to_string(decimals)));
    EXPECT_EQ(digits.text_of(digits.kept(1.0 / 3, 1), 1, "1").size(), 2 + decimals) << decimals;
  }
}

TEST(TextDigits, FloatsAreWrittenAsFloatsWhereTheyAreTheCoarserOnes) {
  TextDigits digits = digits_of({"0.1", "-0.49023438", "nan", "1e30", "x", ""});
  digits.limit_to_float();
  EXPECT_EQ(digits.text_of(digits.kept(1.0 / 3, 0.1), 0.1, "0.1"), "0.33333334");
  EXPECT_EQ(digits.kept(0.100000000001, 0.1), digits.kept(0.1, 0.1));
  EXPECT_GT(digits.step(1000, 999), 6e-5);
}

TEST(TextDigits, ATinyNumberHasNoLongRowOfZeros) {
  const TextDigits digits = digits_of({"0", "1.25e-38"});
  EXPECT_EQ(digits.text_of(1.5e-36, 0, "0"), "1.5e-36");
}

}  // namespace
}  // namespace burnish
