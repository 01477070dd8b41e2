#pragma once

#include <string>

namespace burnish {

inline constexpr int kLengthDigits = 3;
inline constexpr int kDeviationDigits = 4;
inline constexpr int kRulerDigits = 5;

/// Returns a length and its unit: "0.0123 mm", "1510 m". An empty unit is left out.
std::string length_text(double length, const std::string& unit, int digits = kLengthDigits);

}  // namespace burnish
