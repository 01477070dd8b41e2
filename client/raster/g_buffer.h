#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace burnish {

/// Keeps, of a sample that shows a surface, the values that light from the surroundings needs.
struct GBufferSample {
  std::array<int16_t, 3> normal{};  ///< camera space, times 32767
  uint16_t strength = 0;            ///< of the light, times 65535
  uint16_t part = 0;                ///< of the surface in the colour, times 65535
  std::array<uint8_t, 3> colour{};  ///< sRGB, before that light
};

/// One for each sample, in the order of Visibility. Samples without a surface have only a colour.
using GBuffer = std::vector<GBufferSample>;

}  // namespace burnish
