#include "common/mesh/srgb.h"

#include <algorithm>
#include <cmath>

namespace burnish {

uint8_t unit_byte(float value) {
  return static_cast<uint8_t>(std::lround(255 * (value > 0 ? std::min(value, 1.F) : 0)));
}

uint8_t srgb_byte(float linear) {
  return unit_byte(linear <= 0.0031308F ? 12.92F * linear
                                        : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F);
}

float linear_of_srgb(uint8_t byte) {
  const float value = static_cast<float>(byte) / 255;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

Rgba8 changed_colour(Rgba8 colour, const Vec3f& change) {
  for (int channel = 0; channel < 3; ++channel)
    if (change[channel] != 0)
      colour[channel] = srgb_byte(linear_of_srgb(colour[channel]) + change[channel]);
  return colour;
}

}  // namespace burnish
