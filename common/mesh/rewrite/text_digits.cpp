#include "common/mesh/rewrite/text_digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "common/mesh/text_values.h"

namespace burnish {

// Doubles hold these exactly.
static constexpr std::array<double, 23> kPowersOfTen = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Returns 10^decimals if it is exact, else 0.
static double exact_power(int decimals) {
  return decimals >= 0 && decimals < static_cast<int>(kPowersOfTen.size())
             ? kPowersOfTen[static_cast<size_t>(decimals)]
             : 0;
}

static std::string_view mantissa_of(std::string_view token) {
  return token.substr(0, token.find_first_of("eE"));
}

/// Returns the digits from the first that is not 0; none for 0.
static int significant_digits(std::string_view token) {
  int digits = 0;
  for (const char c : mantissa_of(token))
    if (c >= '0' && c <= '9') digits += digits > 0 || c != '0';
  return digits;
}

static int decimals_in(std::string_view text) {
  const size_t point = text.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

static int exponent_of(double value) {
  return value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
}

static std::string fixed_text(double value, int decimals) {
  char text[512];
  auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr;
  if (decimals_in({text, static_cast<size_t>(end - text)}) > decimals)
    end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  return {text, end};
}

static std::string scientific_text(double value, int decimals) {
  char text[512];
  const int digits = std::clamp(decimals + exponent_of(value), 0, 17);
  return {
      text,
      std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits).ptr};
}

void TextDigits::add(std::string_view token) {
  double value;
  if (!parse_double(token, value) || !is_coordinate(value)) return;
  decimals_ = std::max(decimals_, -last_digit_exponent(token));
  digits_ = std::max(digits_, significant_digits(token));
  exceed_float_ = exceed_float_ || burnish::exceeds_float(token, value);
}

int TextDigits::decimals_of(double before) const {
  return before == 0 ? decimals_ : std::min(decimals_, digits_ - 1 - exponent_of(before));
}

double TextDigits::step(double before) const {
  return std::pow(10.0, -decimals_of(before));
}

double TextDigits::kept(double value, double before) const {
  constexpr double kExactMax = 0x1p53;
  const int decimals = decimals_of(before);
  const double power = exact_power(decimals);
  // The quotient of two exact numbers is the double nearest to the decimal number.
  if (power > 0 && std::abs(value) * power < kExactMax)
    return std::round(value * power) / power + 0.0;  // turns -0 into 0
  double kept = value;
  parse_double(decimals < 0 ? scientific_text(value, decimals) : fixed_text(value, decimals), kept);
  return kept + 0.0;
}

std::string TextDigits::text_of(double value, double before, std::string_view old) const {
  const int decimals = decimals_of(before);
  const size_t exponent = old.find_first_of("eE");
  if (decimals < 0 || exponent != std::string_view::npos) {
    std::string text = scientific_text(value, decimals);
    if (exponent != std::string_view::npos && old[exponent] == 'E')
      std::replace(text.begin(), text.end(), 'e', 'E');
    return text;
  }
  std::string text = fixed_text(value, decimals);
  const int missing = decimals_in(old) - decimals_in(text);
  if (missing > 0) text.append(decimals_in(text) == 0 ? "." : "").append(missing, '0');
  return text;
}

}  // namespace burnish
