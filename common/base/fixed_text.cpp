#include "common/base/fixed_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace burnish {

std::string fixed_text(double number, int digits) {
  constexpr double kLeast = 1e-6, kMost = 1e12;
  constexpr int kTextMax = 64;
  char text[kTextMax];
  const double size = std::abs(number);
  if (!(size >= kLeast && size < kMost)) {  // 0 and what is not a number too
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
  }
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  std::snprintf(text, sizeof text, "%.*f", std::max(0, digits - before), number);
  std::string fixed = text;
  if (fixed.find('.') == std::string::npos) return fixed;
  fixed.erase(fixed.find_last_not_of('0') + 1);
  if (fixed.back() == '.') fixed.pop_back();
  return fixed;
}

}  // namespace burnish
