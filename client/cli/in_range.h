#pragma once

#include <limits>
#include <string>

#include <CLI/CLI.hpp>

#include "common/base/text.h"

namespace burnish {

/// Returns a number as people write it: 100000 and 1e+18.
inline std::string limit_text(double limit) {
  constexpr double kWholeMax = 1e9;
  const auto whole = static_cast<long long>(limit < kWholeMax && limit > -kWholeMax ? limit : 0);
  return static_cast<double>(whole) == limit ? std::to_string(whole) : shortest_text(limit);
}

/// Takes a number from `least` to `most`. CLI::Range takes what is no number as well, and its
/// message has all digits of a limit, and six zeros behind it.
template <typename T>
CLI::Validator in_range(T least, T most) {
  const auto check = [=](std::string& text) -> std::string {
    T value;
    if (!CLI::detail::lexical_cast(text, value)) return "'" + text + "' is not a number";
    if (value >= least && value <= most) return "";  // false for NaN
    const auto limit = [](T bound) { return limit_text(static_cast<double>(bound)); };
    return text + " is outside " + limit(least) + " to " + limit(most);
  };
  return CLI::Validator(check, CLI::Range(least, most).get_description());
}

/// Takes a number above 0.
inline CLI::Validator above_zero() {
  const auto check = [](std::string& text) -> std::string {
    double value;
    if (!CLI::detail::lexical_cast(text, value)) return "'" + text + "' is not a number";
    return value > 0 && value <= std::numeric_limits<double>::max()
               ? ""
               : text + " is not a number above 0";
  };
  return CLI::Validator(check, "POSITIVE");
}

/// Takes any text but an empty one, which would count as no option.
inline CLI::Validator not_empty() {
  return CLI::Validator(
      [](std::string& text) -> std::string { return text.empty() ? "'' names nothing" : ""; }, "");
}

}  // namespace burnish
