#include "common/mesh/reading/text_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "common/base/limits.h"
#include "common/mesh/reading/odd_vertices.h"

namespace burnish {

std::string in_quotes(std::string_view token) {
  constexpr size_t kShownMax = 40;
  std::string text = "'";
  for (const char c : token.substr(0, kShownMax)) text += c >= ' ' && c <= '~' ? c : '?';
  if (token.size() > kShownMax) text += "...";
  return text + "'";
}

std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string integer_text(double value) {
  char text[400];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr};
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

template <typename T>
static bool parse_number(std::string_view token, T& value) {
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc() && end == token.data() + token.size();
}

/// "1.#QNAN0" and "-1.#IND" are how old programs of Windows write what is no number.
static bool is_old_nan(std::string_view token) {
  if (token.starts_with('-')) token.remove_prefix(1);
  return token.starts_with("1.#");
}

bool parse_double(std::string_view token, double& value) {
  if (parse_number(token, value)) return true;
  if (!is_old_nan(token)) return false;
  value = std::numeric_limits<double>::quiet_NaN();
  return true;
}
bool parse_integer(std::string_view token, int64_t& value) {
  return parse_number(token, value);
}

int last_digit_exponent(std::string_view token) {
  const size_t mantissa_end = std::min(token.find_first_of("eE"), token.size());
  const size_t point = token.substr(0, mantissa_end).find('.');
  int64_t exponent = 0;
  if (mantissa_end < token.size()) parse_integer(token.substr(mantissa_end + 1), exponent);
  if (point != std::string_view::npos) exponent -= static_cast<int64_t>(mantissa_end - point - 1);
  return static_cast<int>(std::clamp<int64_t>(exponent, -400, 400));
}

bool exceeds_float(std::string_view token, double value) {
  const double moved_by = std::abs(static_cast<double>(static_cast<float>(value)) - value);
  return moved_by > 0 && moved_by > std::pow(10.0, last_digit_exponent(token));
}

bool is_coordinate(double value) {
  return std::abs(value) <= kCoordinateMagnitudeMax;  // false for NaN
}

static std::string name_of(ElementName element) {
  return std::string(element.kind) + " " + std::to_string(element.number);
}

std::string coordinate_complaint(ElementName element, int axis, const std::string& value) {
  return name_of(element) + ": " + "xyz"[axis] + " = " + value +
         "; coordinates must be finite and within ±1e18";
}

static Status coordinate_error(const TextScanner& scanner, ElementName element, int axis,
                               std::string_view token) {
  if (token.empty())
    return scanner.error(name_of(element) + " has " + std::to_string(axis) +
                         " of its 3 coordinates");
  double ignored;
  if (!parse_double(token, ignored))
    return scanner.error(name_of(element) + ": " + "xyz"[axis] + " = " + in_quotes(token) +
                         " is not a number in the range of a double");
  return scanner.error(coordinate_complaint(element, axis, std::string(token)));
}

Status parse_position(const PositionWords& words, const TextScanner& scanner, ElementName element,
                      OddVertices* odd, Vec3d& position, bool& has_doubles) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view token = words[static_cast<size_t>(axis)];
    double value;
    if (!parse_double(token, value)) return coordinate_error(scanner, element, axis, token);
    position[axis] = value;
    if (is_coordinate(value)) {
      if (!has_doubles) has_doubles = exceeds_float(token, value);
      continue;
    }
    const Status complaint = coordinate_error(scanner, element, axis, token);
    if (odd == nullptr) return complaint;
    odd->keep(element.number, complaint);
  }
  return Status::ok();
}

}  // namespace burnish
