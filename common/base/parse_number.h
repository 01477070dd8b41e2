#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

#ifdef __wasm__
#include <cstdlib>
#include <string>
#endif

namespace burnish {

#ifdef __wasm__
// The library of WASI has std::from_chars for whole numbers alone. Its strtod takes more texts:
// spaces, a plus, and hexadecimal numbers.
inline std::optional<double> parse_real_by_c(std::string_view text) {
  if (text.empty() || text.find_first_of(" \t\r\n\f\vxX") != text.npos || text[0] == '+') return {};
  const std::string ended(text);
  char* end = nullptr;
  const double value = std::strtod(ended.c_str(), &end);
  const bool is_too_large = value - value != 0 && ended.find_first_of("iInN") == ended.npos;
  if (end != ended.c_str() + ended.size() || is_too_large) return std::nullopt;
  return value;
}
#endif

/// Parses a number that is all of `text`. Returns nothing if it is not a number or does not fit.
template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
#ifdef __wasm__
  if constexpr (std::is_floating_point_v<Number>) {
    const auto value = parse_real_by_c(text);
    return value ? std::optional(static_cast<Number>(*value)) : std::nullopt;
  } else
#endif
  {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
  }
}

}  // namespace burnish
