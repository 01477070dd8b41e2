#include "common/edit/edge_filter.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const EdgeFilter& filter) {
  const Status status = check_edge_filter(filter);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  return status.message();
}

TEST(EdgeFilter, OfAllPresetsIsValid) {
  ASSERT_EQ(edge_presets().size(), 4u);
  for (const EdgePreset& preset : edge_presets())
    EXPECT_TRUE(check_edge_filter(preset.filter).is_ok()) << preset.name;
}

TEST(EdgeFilter, AWrongValueIsNamedWithItsLimits) {
  EXPECT_THAT(refusal({.strength = 2}), AllOf(HasSubstr("strength 2"), HasSubstr("0..1")));
  EXPECT_THAT(refusal({.edge_angle = 1}), AllOf(HasSubstr("angle 1"), HasSubstr("5..120")));
  EXPECT_THAT(refusal({.passes = 101}), AllOf(HasSubstr("passes 101"), HasSubstr("1..100")));
  EXPECT_THAT(refusal({.passes = 0}), HasSubstr("passes 0"));
  EXPECT_THAT(refusal({.crispness = 1.5}), AllOf(HasSubstr("crispness 1.5"), HasSubstr("0..1")));
}

TEST(EdgeFilter, NumbersThatAreNoneAreRefused) {
  refusal({.strength = NAN});
  refusal({.edge_angle = NAN});
  refusal({.crispness = NAN});
}

TEST(EdgeFilter, ItsKindHasAWord) {
  EXPECT_EQ(*parse_normal_filter("edges"), NormalFilterKind::kEdges);
  EXPECT_EQ(*parse_normal_filter("bilateral"), NormalFilterKind::kBilateral);
  EXPECT_THAT(parse_normal_filter("median").status().message(), HasSubstr("'median'"));
}

}  // namespace
}  // namespace burnish
