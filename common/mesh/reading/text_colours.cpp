#include "common/mesh/reading/text_colours.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/reading/text_values.h"

namespace burnish {

std::optional<std::array<float, 3>> next_colour(TextScanner& scanner) {
  std::array<float, 3> rgb;
  for (float& channel : rgb) {
    double value;
    if (!parse_double(scanner.next_token(), value)) return std::nullopt;
    channel = static_cast<float>(value);
  }
  return rgb;
}

uint8_t colour_byte(float channel, float scale) {
  const float known = channel >= 0 ? channel : 0;  // NaN too
  return static_cast<uint8_t>(std::lround(std::min(known * scale, 255.0F)));
}

void TextColours::set(size_t vertex, const std::array<float, 3>& rgb) {
  colours_.resize(vertex, {kUnset, kUnset, kUnset});
  std::array<float, 3> colour;
  for (int i = 0; i < 3; ++i) colour[i] = rgb[i] >= 0 ? rgb[i] : 0;  // NaN too
  largest_ = largest_channel(largest_, rgb);
  colours_.push_back(colour);
}

void TextColours::set_known(const std::array<float, 3>& from, Rgba8& to) const {
  if (from[0] == kUnset) return;
  for (int i = 0; i < 3; ++i) to[i] = colour_byte(from[i], colour_scale(largest_));
}

}  // namespace burnish
