#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/mesh/ply/ply_layout.h"
#include "common/mesh/ply/ply_type.h"

namespace burnish {

/// Returns a channel of a PLY file as a byte. `full` is the number of a full channel.
inline uint8_t colour_byte(double value, double full) {
  const double scaled = 255 * value / full;
  return static_cast<uint8_t>(std::lround(scaled >= 0 ? std::min(scaled, 255.0) : 0));
}

/// Returns the channel that colour_byte() reads as this byte.
inline double channel_of(uint8_t byte, double full) {
  return byte * full / 255;
}

/// Returns the number of a full channel: 65535 for 16 bits and 255 for other integers. Floats go to
/// 1, or to 255 if the largest one of the file does.
inline double full_channel(PlyType type, double largest_float) {
  constexpr double kRounded = 1.5;  // a little above 1 is still 1
  if (!is_integer(type)) return largest_float > kRounded ? 255 : 1;
  return type == PlyType::kUint16 ? 65535 : 255;
}

/// Returns the largest finite float among the colours of the element vertex; 0 if there is none.
/// Takes a copy of the source that stands before the element. Stops at what cannot be read.
template <typename Source>
double largest_float_channel(Source source, const PlyElement& vertex, const PlyLayout& layout) {
  double largest = 0;
  for (uint64_t v = 0; v < vertex.count; ++v) {
    for (size_t p = 0; p < vertex.properties.size(); ++p) {
      const PlyProperty& property = vertex.properties[p];
      double value = 0;
      if (property.is_list()) {
        if (!source.read(*property.count_type, value) || !(value >= 0) ||
            value > static_cast<double>(source.values_left_max(property.type)) ||
            !source.skip(property.type, static_cast<uint64_t>(value)))
          return largest;
        continue;
      }
      if (!source.read(property.type, value)) return largest;
      const size_t slot = layout.vertex_slots[p];
      const bool is_colour = slot >= kPlyRed && slot < kPlyRed + 3 && !is_integer(property.type);
      if (is_colour && std::isfinite(value)) largest = std::max(largest, value);
    }
    if (!source.at_line_end()) return largest;
  }
  return largest;
}

/// Returns whether a colour of the file is floats, which largest_float_channel() must look at.
inline bool has_float_colours(const PlyElement& vertex, const PlyLayout& layout) {
  if (!layout.has_colours) return false;
  for (size_t p = 0; p < vertex.properties.size(); ++p)
    if (layout.vertex_slots[p] >= kPlyRed && layout.vertex_slots[p] < kPlyIgnored &&
        !is_integer(vertex.properties[p].type))
      return true;
  return false;
}

}  // namespace burnish
