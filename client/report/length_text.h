#pragma once

#include <string>

#include "common/base/fixed_text.h"

namespace burnish {

inline constexpr int kLengthDigits = 3;
inline constexpr int kDeviationDigits = 4;
inline constexpr int kRulerDigits = 5;

/// Returns a length and its unit: "0.0123 mm", "1510 m". An empty unit is left out.
inline std::string length_text(double length, const std::string& unit, int digits = kLengthDigits) {
  const std::string number = fixed_text(length, digits);
  return unit.empty() ? number : number + (" " + unit);
}

}  // namespace burnish
