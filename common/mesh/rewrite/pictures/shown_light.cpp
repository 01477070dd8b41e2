#include "common/mesh/rewrite/pictures/shown_light.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/textures/texel_change.h"

namespace burnish {

static double light_of(double share) {
  return std::pow(std::max(share, 0.0), kShownGamma);
}

ShownLight::ShownLight() {
  for (size_t i = 0; i < lights_.size(); ++i)
    lights_[i] = static_cast<float>(light_of(static_cast<double>(i) / kLevels));
  for (int byte = 0; byte <= kLevels; ++byte)
    begins_[static_cast<size_t>(byte)] = static_cast<float>(light_of((byte - 0.5) / kLevels));
  size_t byte = 0;
  for (size_t part = 0; part < bytes_.size(); ++part) {
    const float light = static_cast<float>(part) / kParts;
    while (byte < kLevels && begins_[byte + 1] <= light) ++byte;
    bytes_[part] = static_cast<uint8_t>(byte);
  }
}

float ShownLight::of_value(uint16_t value, uint16_t max) const {
  if (max == kLevels) return lights_[value];
  return std::pow(static_cast<float>(value) / max, static_cast<float>(kShownGamma));
}

uint16_t ShownLight::fine_value_of(float light, uint16_t max) {
  return static_cast<uint16_t>(
      std::lround(max * std::pow(light, static_cast<float>(1 / kShownGamma))));
}

}  // namespace burnish
