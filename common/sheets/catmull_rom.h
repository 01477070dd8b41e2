#pragma once

#include <array>

namespace burnish {

/// Returns the weights of the four texels around a place `part` behind the second one: 0 to 1.
inline std::array<float, 4> catmull_rom(float part) {
  const float square = part * part;
  const float cube = square * part;
  return {-0.5f * cube + square - 0.5f * part, 1.5f * cube - 2.5f * square + 1,
          -1.5f * cube + 2 * square + 0.5f * part, 0.5f * cube - 0.5f * square};
}

}  // namespace burnish
