#include "common/edit/equaliser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

std::string refusal(const std::vector<Band>& bands) {
  return check_equaliser({bands}).message();
}

TEST(EqualiserOfBands, IsRefusedWithTheBandItsValueAndTheLimit) {
  EXPECT_EQ(refusal({{0.2, 1}, {0.24, 10}}), "");
  EXPECT_THAT(refusal({{0.2, 1}, {-1, 1}}), HasSubstr("band 2: size -1"));
  EXPECT_THAT(refusal({{2e18, 1}}), HasSubstr("1e+18"));
  EXPECT_THAT(refusal({{0.2, 10.5}}), HasSubstr("gain 10.5 is outside 0 to 10"));
  EXPECT_THAT(refusal({{0.2, 1}, {0.23, 1}}), HasSubstr("at least 1.2 times the size 0.2"));
  EXPECT_THAT(refusal(std::vector<Band>(7, {1, 1})), HasSubstr("7 bands: the limit is 6"));
}

TEST(EqualiserOfBands, ABandIsReadFromItsText) {
  EXPECT_EQ(parse_band("0.25:1.5").value(), (Band{0.25, 1.5}));
  EXPECT_THAT(parse_band("0.25").status().message(), HasSubstr("'0.25' is not SIZE:GAIN"));
  EXPECT_THAT(parse_band("x:1").status().message(), HasSubstr("'x'"));
}

TEST(EqualiserOfBands, AWaveOfTheSizeOfASilentBandIsHalved) {
  EXPECT_DOUBLE_EQ(response({{{3, 0}}}, 3), 0.5);
  EXPECT_LT(response({{{3, 0}}}, 0.3), 0.01);
  EXPECT_GT(response({{{3, 0}}}, 30), 0.99);
}

TEST(EqualiserOfBands, GainsOfOneChangeNoWave) {
  for (const double wavelength : {0.01, 0.7, 40.0})
    EXPECT_DOUBLE_EQ(response({{{0.1, 1}, {1, 1}, {10, 1}}}, wavelength), 1);
}

}  // namespace
}  // namespace burnish
