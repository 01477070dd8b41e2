#include "client/model/input/typed_number.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

const TypedValue kStrength{"Strength", 0.01, 1};

TEST(TypedNumber, TakesAPointOrACommaAndSpacesAround) {
  for (const char* text : {"0.35", "0,35", " 0,35 ", "3.5e-1"}) {
    const auto typed = read_typed_number(kStrength, text);
    ASSERT_TRUE(typed.is_ok()) << text;
    EXPECT_EQ(typed->value, 0.35) << text;
    EXPECT_EQ(typed->note, "");
  }
}

TEST(TypedNumber, RefusesWhatIsNotANumberAndNamesIt) {
  for (const char* text : {"5 mm", "", "1.000,5", "abc", "nan", "inf", "0x10"}) {
    const auto typed = read_typed_number(kStrength, text);
    ASSERT_FALSE(typed.is_ok()) << text;
    EXPECT_EQ(typed.status().code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(typed.status().message(), HasSubstr(text));
    EXPECT_THAT(typed.status().message(), HasSubstr("Strength"));
  }
}

TEST(TypedNumber, TellsWhichLimitTookThePlaceOfANumber) {
  const auto high = read_typed_number(kStrength, "35");
  ASSERT_TRUE(high.is_ok());
  EXPECT_EQ(high->value, 1);
  EXPECT_THAT(high->note, HasSubstr("35"));
  EXPECT_THAT(high->note, HasSubstr("0.01..1"));
  EXPECT_EQ(read_typed_number(kStrength, "-2")->value, 0.01);
}

}  // namespace
}  // namespace burnish
