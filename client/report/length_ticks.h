#pragma once

#include <string>
#include <vector>

namespace burnish {

/// A mark on an axis.
struct LengthTick {
  double at;         ///< the length
  std::string text;  ///< as length_text() gives it; the last mark of an axis alone has the unit
};

/// Returns the marks from `low` to `high`. Their distance is 1, 2 or 5 times a power of ten, and at
/// least `apart`. Returns nothing where numbers are too large, too small or not finite.
std::vector<LengthTick> length_ticks(double low, double high, double apart,
                                     const std::string& unit);

}  // namespace burnish
