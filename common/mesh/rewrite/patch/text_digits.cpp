#include "common/mesh/rewrite/patch/text_digits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "common/mesh/reading/text_values.h"

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

static double step_of(int decimals) {
  const double power = exact_power(decimals);
  return power > 0 ? 1 / power : std::pow(10.0, -decimals);
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

/// Returns a number's float in the shortest text's value, which is another double than the float.
static double shortest_float(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(value)).ptr;
  parse_double({text, static_cast<size_t>(end - text)}, value);
  return value + 0.0;  // turns -0 into 0
}

static double float_step(double value) {
  const float size = std::abs(static_cast<float>(value));
  return static_cast<double>(std::nextafter(size, std::numeric_limits<float>::infinity())) -
         static_cast<double>(size);
}

static std::string scientific_text(double value, int decimals) {
  char text[64];
  const int digits = std::clamp(decimals + exponent_of(value), 0, 17);
  auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
  if (decimals_in(mantissa_of({text, static_cast<size_t>(end - text)})) > digits)
    end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, digits).ptr;
  return {text, end};
}

/// Adds zeros to a mantissa until it has this many decimals.
static void pad(std::string& text, int decimals) {
  const std::string_view mantissa = mantissa_of(text);
  const int missing = decimals - decimals_in(mantissa);
  if (missing <= 0) return;
  const std::string point = decimals_in(mantissa) == 0 ? "." : "";
  text.insert(mantissa.size(), point + std::string(static_cast<size_t>(missing), '0'));
}

void TextDigits::add(std::string_view token) {
  double value;
  if (!parse_double(token, value) || !is_coordinate(value)) return;
  decimals_ = std::max(decimals_, -last_digit_exponent(token));
  digits_ = std::max(digits_, significant_digits(token));
}

void TextDigits::refine(double step_max) {
  if (!(step_max > 0)) return;
  decimals_min_ = static_cast<int>(std::clamp(std::ceil(-std::log10(step_max)), -400.0, 400.0));
}

int TextDigits::decimals_of(double before) const {
  const int own = before == 0 ? decimals_ : std::min(decimals_, digits_ - 1 - exponent_of(before));
  return std::max(own, decimals_min_);
}

double TextDigits::step(double kept, double before) const {
  const double step = step_of(decimals_of(before));
  return is_float_ ? std::max(step, float_step(kept)) : step;
}

double TextDigits::kept(double value, double before) const {
  // Products stay well below the integers of a double, so that they round to the right one.
  constexpr double kExactMax = 0x1p50;
  const int decimals = decimals_of(before);
  // A reader takes a text for doubles where a float rounds it by more than its last digit.
  if (is_float_ && step_of(decimals) < float_step(value) / 2) return shortest_float(value);
  const double power = exact_power(decimals);
  // The quotient of two exact numbers is the double nearest to the decimal number.
  if (power > 0 && std::abs(value) * power < kExactMax)
    return std::round(value * power) / power + 0.0;  // turns -0 into 0
  double kept = value;
  parse_double(decimals < 0 ? scientific_text(value, decimals) : fixed_text(value, decimals), kept);
  return kept + 0.0;
}

std::string TextDigits::text_of(double kept, double before, std::string_view old) const {
  constexpr size_t kFixedMax = 24;  // more characters are zeros
  const int decimals = decimals_of(before);
  const size_t exponent = old.find_first_of("eE");
  const bool is_scientific = decimals < 0 || exponent != std::string_view::npos;
  std::string text = is_scientific ? scientific_text(kept, decimals) : fixed_text(kept, decimals);
  if (text.size() > kFixedMax && text.size() > old.size()) text = number_text(kept);
  pad(text, decimals_in(mantissa_of(old)));
  if (exponent != std::string_view::npos && old[exponent] == 'E')
    std::replace(text.begin(), text.end(), 'e', 'E');
  return text;
}

}  // namespace burnish
