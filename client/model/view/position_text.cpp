#include "client/model/view/position_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace burnish {

std::string position_text(const Vec3d& point, double diagonal) {
  constexpr int kDigits = 6;  // of the diagonal
  const int before = diagonal > 0 ? static_cast<int>(std::floor(std::log10(diagonal))) + 1 : 0;
  const int decimals = std::clamp(kDigits - before, 0, 12);
  char text[128];
  std::snprintf(text, sizeof text, "%.*f %.*f %.*f", decimals, point.x(), decimals, point.y(),
                decimals, point.z());
  return text;
}

}  // namespace burnish
