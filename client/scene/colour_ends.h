#pragma once

#include <algorithm>

namespace burnish {

inline constexpr double kColourEndMin = 1e-3, kColourEndMax = 1e3;

/// Returns an end within its limits; 1 for what is not a number.
inline double clamped_end(double end) {
  return end >= kColourEndMin  ? std::min(end, kColourEndMax)
         : end < kColourEndMin ? kColourEndMin
                               : 1;
}

/// The ends of a scale of colours around 0: full blue at -low, full red at high.
struct ColourEnds {
  double low = 1;   ///< kColourEndMin..kColourEndMax
  double high = 1;  ///< likewise

  bool operator==(const ColourEnds&) const = default;

  /// Returns the end on the side of a value.
  double of(double value) const { return value < 0 ? low : high; }
};

}  // namespace burnish
