#include "common/mesh/text_colours.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/text_values.h"

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

std::vector<Rgba8> TextColours::finish(size_t vertices) {
  std::vector<Rgba8> result;
  if (colours_.empty()) return result;
  const float scale = colour_scale(largest_);
  result.assign(vertices, {255, 255, 255, 255});
  for (size_t v = 0; v < colours_.size(); ++v) {
    if (colours_[v][0] == kUnset) continue;
    for (int i = 0; i < 3; ++i) result[v][i] = colour_byte(colours_[v][i], scale);
  }
  return result;
}

}  // namespace burnish
