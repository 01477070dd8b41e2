#pragma once

#include <cmath>
#include <numbers>

namespace burnish {

/// Returns `base` to the power of `exponent`, for a positive base, to a few units in the last
/// place. The browser's core, in which every kilobyte counts, carries the tables of exp() and
/// log(); those of pow() and log2() would be five more.
inline double power(double base, double exponent) {
  return std::exp(exponent * std::log(base));
}

/// Returns the logarithm to base 2, likewise.
inline double binary_logarithm(double number) {
  return std::log(number) / std::numbers::ln2;
}

/// Returns what lies `part` (0 to 1) of the way from `from` to `to`, both positive, in equal
/// ratios.
inline double between_by_ratio(double from, double to, double part) {
  return from * power(to / from, part);
}

}  // namespace burnish
