#include "common/mesh/textures/texel_change.h"

#include <array>
#include <cmath>

#include "common/mesh/srgb.h"

namespace burnish {

static float shown_light(uint8_t byte) {
  static const auto lights = [] {
    std::array<float, 256> made;
    for (size_t i = 0; i < made.size(); ++i)
      made[i] = static_cast<float>(std::pow(static_cast<double>(i) / 255, kShownGamma));
    return made;
  }();
  return lights[byte];
}

static Vec3f shown_light(Rgba8 colour) {
  return {shown_light(colour[0]), shown_light(colour[1]), shown_light(colour[2])};
}

TexelChange texel_change(Rgba8 before, const Vec3f& change, float gain) {
  const Vec3f whole = linear_colour(before) + change;
  const Vec3f beyond = whole - whole.cwiseMax(0).cwiseMin(1);
  const Vec3f shown = shown_light(changed_colour(before, change)) + beyond;
  return {gain, shown - gain * shown_light(before)};
}

TexelChange texel_change(Rgba8 before, Rgba8 after) {
  return {1, shown_light(after) - shown_light(before)};
}

}  // namespace burnish
