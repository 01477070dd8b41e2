#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "client/raster/shade_math.h"
#include "common/mesh/rewrite/shown_light.h"

namespace burnish {
namespace {

float light_of_grey(int level) {
  const float share = static_cast<float>(level) / 255;
  return linear({share, share, share}).x;
}

// As scan_colour() of client/raster/fragment.cpp and surface_colour() of
// client/gl/texel_shader.cpp.
double shown_level(int texel, int before, int after) {
  const float changed =
      greater(light_of_grey(texel) + light_of_grey(after) - light_of_grey(before), 0);
  return 255 * power(std::min(changed, 1.F), 1 / shade::kGamma);
}

TEST(ExportedTexel, IsTheOneThatRenderersShow) {
  EXPECT_FLOAT_EQ(static_cast<float>(kShownGamma), shade::kGamma);
  const ShownLight light;
  for (int texel = 0; texel <= 255; texel += 5)
    for (int before = 0; before <= 255; before += 15)
      for (int after = 0; after <= 255; after += 15) {
        const float change =
            light.of_level(static_cast<float>(after)) - light.of_level(static_cast<float>(before));
        const uint16_t exported =
            light.value_of(light.of_value(static_cast<uint16_t>(texel), 255) + change, 255);
        ASSERT_NEAR(exported, shown_level(texel, before, after), 1)
            << texel << " " << before << " " << after;
      }
}

}  // namespace
}  // namespace burnish
