#include "common/mesh/rewrite/pictures/shown_light.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "common/mesh/textures/texel_change.h"

namespace burnish {
namespace {

TEST(ShownLight, EveryChannelComesBack) {
  const ShownLight light;
  for (uint32_t value = 0; value <= 255; ++value)
    EXPECT_EQ(light.value_of(light.of_value(static_cast<uint16_t>(value), 255), 255), value);
  for (uint32_t value = 0; value <= 65535; ++value)
    ASSERT_EQ(light.value_of(light.of_value(static_cast<uint16_t>(value), 65535), 65535), value);
}

TEST(ShownLight, TheNearestByteIsTaken) {
  const ShownLight light;
  for (double level = 0; level < 255; level += 0.0137) {
    const double part = level - std::floor(level);
    if (std::abs(part - 0.5) < 0.01) continue;
    const auto shown = static_cast<float>(std::pow(level / 255, kShownGamma));
    ASSERT_EQ(light.value_of(shown, 255), std::lround(level)) << level;
  }
}

TEST(ShownLight, WhatIsNoLightIsBlackOrWhite) {
  const ShownLight light;
  EXPECT_EQ(light.value_of(-1, 255), 0);
  EXPECT_EQ(light.value_of(std::numeric_limits<float>::quiet_NaN(), 65535), 0);
  EXPECT_EQ(light.value_of(2, 65535), 65535);
}

}  // namespace
}  // namespace burnish
