#include "common/picture/texture_samples.h"

#include <algorithm>

namespace burnish {

TextureSamples::TextureSamples(size_t coordinates) {
  visits_.reserve(2 * coordinates);
  pixels_.reserve(coordinates);
}

void TextureSamples::add(const PixelSquare& at) {
  const auto coordinate = static_cast<uint32_t>(pixels_.size());
  visits_.push_back({at.y.first, {at.x.first, at.x.second}, coordinate, 0});
  visits_.push_back({at.y.second, {at.x.first, at.x.second}, coordinate, 2});
  pixels_.push_back({});
}

void TextureSamples::sort() {
  std::ranges::sort(visits_, {}, &Visit::y);
}

void TextureSamples::take(const PixelRun& run) {
  for (const Visit& visit : std::ranges::equal_range(visits_, run.y, {}, &Visit::y)) {
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t x = visit.x[side];
      if (x < run.first || (x - run.first) % run.step != 0) continue;
      pixels_[visit.coordinate][visit.into + side] = run.pixels[(x - run.first) / run.step];
    }
  }
}

}  // namespace burnish
