#include "client/scene/lighting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Lighting, EveryKindIsFoundByItsName) {
  for (int i = 0; i < kLightKinds; ++i) {
    const auto kind = static_cast<LightKind>(i);
    const auto parsed = parse_light_kind(name_of(kind));
    ASSERT_TRUE(parsed.is_ok()) << i;
    EXPECT_EQ(*parsed, kind);
  }
  EXPECT_THAT(parse_light_kind("neon").status().message(), testing::HasSubstr("neon"));
}

TEST(Lighting, AzimuthRunsFromRightToUpAndElevationToTheEye) {
  EXPECT_TRUE(to_lamp({.azimuth_degrees = 0, .elevation_degrees = 0}).isApprox(Vec3f::UnitX()));
  EXPECT_TRUE(
      to_lamp({.azimuth_degrees = 90, .elevation_degrees = 0}).isApprox(Vec3f::UnitY(), 1e-6f));
  EXPECT_TRUE(
      to_lamp({.azimuth_degrees = 40, .elevation_degrees = 90}).isApprox(Vec3f::UnitZ(), 1e-6f));
}

TEST(Lighting, TheBallShowsTheLampWhereItWasPut) {
  const Eigen::Vector2d place(-0.4, 0.3);
  EXPECT_LT((lamp_on_ball(with_lamp_at({}, place)) - place).norm(), 1e-6);
}

TEST(Lighting, ALampBesideTheBallLiesOnItsRim) {
  const Lighting lighting = with_lamp_at({}, {3, 4});
  EXPECT_EQ(lighting.elevation_degrees, 0);
  EXPECT_LT((lamp_on_ball(lighting) - Eigen::Vector2d(0.6, 0.8)).norm(), 1e-6);
}

TEST(Lighting, ALampInTheMiddleKeepsItsAzimuth) {
  const Lighting lighting = with_lamp_at({.azimuth_degrees = 70}, {0, 0});
  EXPECT_EQ(lighting.azimuth_degrees, 70);
  EXPECT_EQ(lighting.elevation_degrees, 90);
}

TEST(Lighting, ValuesBeyondTheirLimitsAreNamed) {
  EXPECT_TRUE(check_lighting({}).is_ok());
  EXPECT_THAT(check_lighting({.specular = 1.5}).message(), testing::HasSubstr("specular 1.5"));
  EXPECT_THAT(check_lighting({.radiance = 9}).message(), testing::HasSubstr("2"));
  EXPECT_FALSE(check_lighting({.elevation_degrees = -1}).is_ok());
  EXPECT_FALSE(check_lighting({.occlusion = std::nan("")}).is_ok());
}

TEST(Lighting, OnlyLightsOfTheSurroundingsNeedThem) {
  EXPECT_FALSE(needs_surroundings({}));
  EXPECT_FALSE(needs_surroundings({.kind = LightKind::kRaking}));
  EXPECT_TRUE(needs_surroundings({.kind = LightKind::kRadiance}));
  EXPECT_TRUE(needs_surroundings({.kind = LightKind::kBronze, .occlusion = 0.5}));
}

}  // namespace
}  // namespace burnish
