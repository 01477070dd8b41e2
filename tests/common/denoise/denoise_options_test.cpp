#include "common/denoise/denoise_options.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const DenoiseOptions& options) {
  const Status status = validate(options);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  return status.message();
}

TEST(DenoiseOptions, OfAllPresetsAreValid) {
  ASSERT_EQ(denoise_presets().size(), 4u);
  for (const DenoisePreset& preset : denoise_presets())
    EXPECT_TRUE(validate(preset.options).is_ok()) << preset.name;
}

TEST(DenoiseOptions, AWrongValueIsNamedWithItsLimits) {
  EXPECT_THAT(refusal({.sigma = 0.01}),
              AllOf(HasSubstr("edge angle"), HasSubstr("0.01"), HasSubstr("0.04..1.5")));
  EXPECT_THAT(refusal({.passes = 101}),
              AllOf(HasSubstr("passes"), HasSubstr("101"), HasSubstr("0..100")));
  EXPECT_THAT(refusal({.passes = -1}), HasSubstr("-1"));
  EXPECT_THAT(refusal({.crispness = 1.5}),
              AllOf(HasSubstr("crispness"), HasSubstr("1.5"), HasSubstr("0..1")));
  EXPECT_THAT(refusal({.cap = -2}), AllOf(HasSubstr("cap"), HasSubstr("-2")));
}

TEST(DenoiseOptions, NumbersThatAreNoneAreRefused) {
  refusal({.sigma = NAN});
  refusal({.crispness = NAN});
  refusal({.cap = NAN});
}

TEST(DenoiseOptions, TheFilterHasAWord) {
  EXPECT_EQ(*parse_normal_filter("edges"), NormalFilterKind::kEdges);
  EXPECT_EQ(*parse_normal_filter("bilateral"), NormalFilterKind::kBilateral);
  EXPECT_THAT(parse_normal_filter("median").status().message(), HasSubstr("'median'"));
}

}  // namespace
}  // namespace burnish
