#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/mesh/ply_type.h"

namespace burnish {

/// Returns a channel of a PLY file as a byte. Floats go to 1, 16-bit numbers to 65535, all others
/// to 255.
inline uint8_t colour_byte(double value, PlyType type) {
  double scaled = value;
  if (!is_integer(type)) scaled = 255 * value;
  if (type == PlyType::kUint16) scaled = value / 257;
  return static_cast<uint8_t>(std::lround(scaled >= 0 ? std::min(scaled, 255.0) : 0));
}

/// Returns the channel that colour_byte() reads as this byte.
inline double channel_of(uint8_t byte, PlyType type) {
  if (!is_integer(type)) return byte / 255.0;
  return type == PlyType::kUint16 ? 257.0 * byte : 1.0 * byte;
}

}  // namespace burnish
