#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace burnish {

/// Turns the colours of files into the light that renderers add and mix, and back. Light is 0 to 1.
class ShownLight {
 public:
  ShownLight();

  /// Returns the light of a channel, 0 to `max`: 255 or 65535.
  float of_value(uint16_t value, uint16_t max) const;

  /// Returns the nearest channel, 0 to `max`. Light is cut off at black and white; NaN is black.
  uint16_t value_of(float light, uint16_t max) const {
    if (!(light > 0)) return 0;
    if (light >= 1) return max;
    if (max != kLevels) return fine_value_of(light, max);
    size_t byte = bytes_[static_cast<size_t>(static_cast<int>(light * kParts))];
    while (byte < kLevels && begins_[byte + 1] <= light) ++byte;
    return static_cast<uint16_t>(byte);
  }

 private:
  static uint16_t fine_value_of(float light, uint16_t max);

  static constexpr int kLevels = 255, kParts = 4096;

  std::array<float, kLevels + 1> lights_;  // of each byte
  std::array<float, kLevels + 1> begins_;  // the least light of each byte
  std::array<uint8_t, kParts + 1> bytes_;  // not above that of a light
};

}  // namespace burnish
