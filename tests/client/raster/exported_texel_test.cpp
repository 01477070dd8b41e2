#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "client/raster/shade_math.h"
#include "common/mesh/rewrite/pictures/shown_light.h"
#include "common/mesh/textures/texel_change.h"

namespace burnish {
namespace {

Rgba8 grey(int level) {
  const auto byte = static_cast<uint8_t>(level);
  return {byte, byte, byte, 255};
}

float light_of_grey(int level) {
  const float share = static_cast<float>(level) / 255;
  return linear({share, share, share}).x;
}

// As changed_texel() of client/raster/fragment.cpp and surface_colour() of
// client/gl/texel_shader.cpp.
double shown_level(int texel, const TexelChange& change) {
  const float changed = greater(change.gain * light_of_grey(texel) + change.light.x(), 0);
  return 255 * power(std::min(changed, 1.F), 1 / shade::kGamma);
}

TEST(ExportedTexel, IsTheOneThatRenderersShow) {
  EXPECT_FLOAT_EQ(static_cast<float>(kShownGamma), shade::kGamma);
  const ShownLight light;
  for (int texel = 0; texel <= 255; texel += 5)
    for (int before = 0; before <= 255; before += 15)
      for (int after = 0; after <= 255; after += 15) {
        TexelChange change = texel_change(grey(before), grey(after));
        EXPECT_NEAR(change.light.x(), light_of_grey(after) - light_of_grey(before), 1e-5);
        change.gain = 0.5F + static_cast<float>(before) / 100;
        const float own = light.of_value(static_cast<uint16_t>(texel), 255);
        const uint16_t exported = light.value_of(change.gain * own + change.light.x(), 255);
        ASSERT_NEAR(exported, shown_level(texel, change), 1)
            << texel << " " << before << " " << after;
      }
}

}  // namespace
}  // namespace burnish
