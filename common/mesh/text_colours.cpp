#include "common/mesh/text_colours.h"

#include <algorithm>
#include <cmath>

namespace burnish {

void TextColours::set(size_t vertex, const std::array<float, 3>& rgb) {
  colours_.resize(vertex, {kUnset, kUnset, kUnset});
  std::array<float, 3> colour;
  for (int i = 0; i < 3; ++i) {
    colour[i] = rgb[i] >= 0 ? rgb[i] : 0;  // NaN too
    largest_ = std::max(largest_, colour[i]);
  }
  colours_.push_back(colour);
}

std::vector<Rgba8> TextColours::finish(size_t vertices) {
  std::vector<Rgba8> result;
  if (colours_.empty()) return result;
  const float scale = largest_ > 1 ? 1 : 255;
  result.assign(vertices, {255, 255, 255, 255});
  for (size_t v = 0; v < colours_.size(); ++v) {
    if (colours_[v][0] == kUnset) continue;
    for (int i = 0; i < 3; ++i)
      result[v][i] = static_cast<uint8_t>(std::lround(std::min(colours_[v][i] * scale, 255.0F)));
  }
  return result;
}

}  // namespace burnish
