#pragma once

#include <array>
#include <cstdint>

namespace burnish {

/// The gamma that renderers take colours of scans for (kGamma of client/scene/shade_constants.h).
inline constexpr double kShownGamma = 2.2;

/// Turns the colours of files into the light that renderers add and mix, and back. Light is 0 to 1.
class ShownLight {
 public:
  ShownLight();

  /// Returns the light of a level, 0 to 255, which may lie between two bytes. Others are cut off.
  float of_level(float level) const;

  /// Returns the light of a channel, 0 to `max`: 255 or 65535.
  float of_value(uint16_t value, uint16_t max) const;

  /// Returns the nearest channel, 0 to `max`. Light is cut off at black and white; NaN is black.
  uint16_t value_of(float light, uint16_t max) const;

 private:
  static constexpr int kLevels = 255, kPartsOfLevel = 16, kParts = 4096;

  std::array<float, kLevels * kPartsOfLevel + 2> lights_;  // by level
  std::array<float, kLevels + 1> begins_;                  // the least light of each byte
  std::array<uint8_t, kParts + 1> bytes_;                  // not above that of a light
};

}  // namespace burnish
