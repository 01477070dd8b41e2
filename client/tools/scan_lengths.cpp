#include "client/tools/scan_lengths.h"

#include <cmath>

namespace burnish {

double sharp_bend_of(float range, std::span<const float> area) {
  constexpr double kSharpPart = 0.1;
  const size_t half = area.size() / 2;
  double total = 0;
  for (const float part : area) total += part;
  double left = kSharpPart * total;  // of the area, from the sharpest bends down
  for (size_t bin = half; bin-- > 0;) {
    const double part = double{area[half + bin]} + double{area[half - 1 - bin]};
    if (part >= left && part > 0) {
      const double at = static_cast<double>(bin) + 1 - left / part;
      return std::sinh(at / static_cast<double>(half) * std::asinh(double{range}));
    }
    left -= part;
  }
  return 0;
}

}  // namespace burnish
