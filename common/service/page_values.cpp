#include "common/service/page_values.h"

#include <algorithm>
#include <cmath>

namespace burnish {

static constexpr float kStepsMax = 255;

float PageValues::at(size_t vertex) const {
  if (steps.empty()) return low;
  return low + (high - low) * static_cast<float>(steps[vertex]) / kStepsMax;
}

PageValues pack_page_values(PageId page, std::span<const float> values) {
  PageValues packed{.page = page, .low = 0, .high = 0, .steps = {}};
  if (values.empty()) return packed;
  const auto [low, high] = std::ranges::minmax(values);
  packed.low = low;
  packed.high = high;
  if (low == high) return packed;
  for (const float value : values)
    packed.steps.push_back(
        static_cast<uint8_t>(std::lround((value - low) / (high - low) * kStepsMax)));
  return packed;
}

}  // namespace burnish
