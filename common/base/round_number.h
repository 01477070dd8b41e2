#pragma once

#include <initializer_list>

namespace burnish {

/// Returns the largest number that is 1, 2 or 5 times a power of ten and not above `limit`.
/// Needs: a positive, finite limit.
inline double round_number_below(double limit) {
  double tens = 1;
  const bool is_small = limit < 1;
  if (is_small) {
    while (1 / tens > limit) tens *= 10;
  } else {
    while (10 * tens <= limit) tens *= 10;
  }
  // A quotient is nearer to the decimal number than a product with an inexact power.
  const auto times = [&](double step) { return is_small ? step / tens : step * tens; };
  for (const double step : {5.0, 2.0})
    if (times(step) <= limit) return times(step);
  return times(1);
}

}  // namespace burnish
