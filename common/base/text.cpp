#include "common/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "common/base/limits.h"
#include "common/base/parse_number.h"

namespace burnish {

#ifdef __wasm__
// The library's way has tables of 100 kB, which each browser would load. Its rule holds here too:
// the fewest digits that are read back, in the shorter notation, and without an exponent in a tie.
std::string shortest_text(double number) {
  static constexpr int kDigitsMax = 17;
  char scientific[32], fixed[340];  // the largest number has 309 digits
  if (!std::isfinite(number)) return std::isnan(number) ? "nan" : number < 0 ? "-inf" : "inf";
  int digits = 1;
  do std::snprintf(scientific, sizeof scientific, "%.*e", digits - 1, number);
  while (parse_number<double>(scientific) != number && ++digits <= kDigitsMax);
  const int exponent = std::atoi(std::strchr(scientific, 'e') + 1);
  std::snprintf(fixed, sizeof fixed, "%.*f", std::max(0, digits - 1 - exponent), number);
  return std::strlen(fixed) <= std::strlen(scientific) ? fixed : scientific;
}
#else
std::string shortest_text(double number) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number);
  return error == std::errc() ? std::string(text, end) : "?";
}
#endif

std::optional<char32_t> take_character(std::string_view& text) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  // The least code point of each length. A smaller code point has a shorter form, so these bytes
  // are not UTF-8.
  static constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  bool is_utf8 = (first < 0x80 || (first >= 0xc2 && first <= 0xf4)) && length <= text.size();
  char32_t code = length == 1 ? first : first & (0x7fu >> length);
  for (size_t i = 1; is_utf8 && i < length; ++i) {
    is_utf8 = (byte(i) & 0xc0) == 0x80;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  is_utf8 = is_utf8 && code >= kLeast[length] && code <= 0x10ffff && !is_surrogate;
  text.remove_prefix(is_utf8 ? length : 1);
  return is_utf8 ? std::optional(code) : std::nullopt;
}

bool is_control(char32_t c) {
  const bool is_line_end = c == 0x2028 || c == 0x2029;
  const bool turns_direction = (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069) ||
                               c == 0x200e || c == 0x200f || c == 0x061c;
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || is_line_end || turns_direction;
}

bool is_valid_utf8(std::string_view text) {
  while (!text.empty())
    if (!take_character(text)) return false;
  return true;
}

std::string to_hex(std::span<const std::byte> bytes) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string digits;
  for (const std::byte byte : bytes) {
    const auto value = std::to_integer<unsigned>(byte);
    digits += {kHex[value >> 4], kHex[value & 15]};
  }
  return digits;
}

std::string to_valid_utf8(std::string_view text) {
  if (is_valid_utf8(text)) return std::string(text);
  std::string valid;
  while (!text.empty()) {
    const std::string_view before = text;
    const auto character = take_character(text);
    if (!character) {
      valid += "\\x" + to_hex(std::as_bytes(std::span(before.data(), 1)));
    } else if (character == U'\\') {
      valid += "\\\\";
    } else {
      valid += before.substr(0, before.size() - text.size());
    }
  }
  return valid;
}

Status check_name(std::string_view what, std::string_view name) {
  const std::string subject(what);
  if (name.empty()) return invalid_argument(subject + " is empty");
  if (name.size() > kNameBytesMax)
    return invalid_argument(subject + " has " + std::to_string(name.size()) +
                            " bytes, the limit is " + std::to_string(kNameBytesMax));
  while (!name.empty()) {
    const auto character = take_character(name);
    if (!character) return invalid_argument(subject + " is not valid UTF-8");
    if (is_control(*character)) return invalid_argument(subject + " has control characters");
  }
  return Status::ok();
}

std::string name_like(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const std::string_view before = text;
    const auto character = take_character(text);
    if (character && is_control(*character)) continue;
    const std::string_view bytes =
        character ? before.substr(0, before.size() - text.size()) : std::string_view("?");
    if (name.size() + bytes.size() > kNameBytesMax) break;
    name += bytes;
  }
  return name.empty() ? "scan" : name;
}

/// Replaces each character that `is_wanted` refuses by '?', up to `bytes_max` bytes.
template <typename IsWanted>
static std::string cleaned(std::string_view text, size_t bytes_max, IsWanted is_wanted) {
  std::string clean;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view before = rest;
    const auto character = take_character(rest);
    const std::string_view bytes = before.substr(0, before.size() - rest.size());
    const bool wanted = character && is_wanted(*character);
    if (clean.size() + (wanted ? bytes.size() : 1) > bytes_max)
      return clean + "... (" + std::to_string(before.size()) + " more bytes)";
    clean += wanted ? bytes : "?";
  }
  return clean;
}

std::string shortened(std::string_view text, size_t bytes_max) {
  return cleaned(text, bytes_max, [](char32_t) { return true; });
}

std::string one_line(std::string_view text, size_t bytes_max) {
  return cleaned(text, bytes_max, [](char32_t c) { return !is_control(c); });
}

std::string few_names(std::span<const std::string> names) {
  constexpr size_t kNamesMax = 5, kBytesMax = 100;
  std::string text;
  for (const std::string& name : names.first(std::min(names.size(), kNamesMax)))
    text += (text.empty() ? "" : ", ") + one_line(name, kBytesMax);
  if (names.size() > kNamesMax)
    text += " and " + std::to_string(names.size() - kNamesMax) + " more";
  return text;
}

std::string missing_text(const std::string& file, std::span<const std::string> missing) {
  return file + " names files that are not there: " + few_names(missing);
}

std::string seconds_text(std::chrono::milliseconds time) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g s", static_cast<double>(time.count()) / 1000);
  return text;
}

}  // namespace burnish
