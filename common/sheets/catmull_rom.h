#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "common/base/types.h"
#include "common/sheets/push_pull.h"

namespace burnish {

/// Returns a colour as a texel.
inline Texel texel_of(const Rgba8& colour) {
  using Bytes [[gnu::vector_size(4)]] = uint8_t;  // at once: four conversions take twice as long
  using Floats [[gnu::vector_size(16)]] = float;
  Bytes bytes;
  std::memcpy(&bytes, colour.data(), sizeof bytes);
  const Floats floats = __builtin_convertvector(bytes, Floats);
  Texel texel;
  std::memcpy(texel.data(), &floats, sizeof floats);
  return texel;
}

/// Returns the weights of the four texels around a place `part` behind the second one: 0 to 1.
inline std::array<float, 4> catmull_rom(float part) {
  const float square = part * part;
  const float cube = square * part;
  return {-0.5f * cube + square - 0.5f * part, 1.5f * cube - 2.5f * square + 1,
          -1.5f * cube + 2 * square + 0.5f * part, 0.5f * cube - 0.5f * square};
}

/// Returns the colour between 4 x 4 texels, behind the second ones by so much. `colour_at(row,
/// column)` gives them: 0 to 3.
template <typename ColourAt>
Texel filtered_by_catmull_rom(double part_x, double part_y, const ColourAt& colour_at) {
  const auto along_x = catmull_rom(static_cast<float>(part_x));
  const auto along_y = catmull_rom(static_cast<float>(part_y));
  Texel sum = Texel::Zero();
  for (int row = 0; row < 4; ++row) {
    Texel along = Texel::Zero();
    for (int column = 0; column < 4; ++column)
      along += along_x[column] * texel_of(colour_at(row, column));
    sum += along_y[row] * along;
  }
  return sum.cwiseMax(0.0f).cwiseMin(255.0f);  // splines overshoot
}

}  // namespace burnish
