#include "common/base/utf8.h"

#include <cstdint>

namespace burnish {

namespace {

/// The first byte of a character says how long it is and where its second byte lies.
struct Lead {
  size_t bytes;  // 0: no character begins so
  uint8_t second_min, second_max;
};

// Table 3-7 of the Unicode Standard. The narrower ranges keep out overlong forms (E0, F0),
// surrogates (ED) and what lies above U+10FFFF (F4).
Lead lead_of(uint8_t byte) {
  if (byte < 0x80) return {1, 0, 0};
  if (byte < 0xc2) return {0, 0, 0};
  if (byte < 0xe0) return {2, 0x80, 0xbf};
  if (byte == 0xe0) return {3, 0xa0, 0xbf};
  if (byte == 0xed) return {3, 0x80, 0x9f};
  if (byte < 0xf0) return {3, 0x80, 0xbf};
  if (byte == 0xf0) return {4, 0x90, 0xbf};
  if (byte < 0xf4) return {4, 0x80, 0xbf};
  if (byte == 0xf4) return {4, 0x80, 0x8f};
  return {0, 0, 0};
}

/// The bytes of the character that `text` begins with; 0: it does not begin with one.
size_t first_character(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  const Lead lead = lead_of(byte(0));
  if (lead.bytes == 0 || lead.bytes > text.size()) return 0;
  for (size_t i = 1; i < lead.bytes; ++i) {
    const uint8_t least = i == 1 ? lead.second_min : 0x80;
    const uint8_t most = i == 1 ? lead.second_max : 0xbf;
    if (byte(i) < least || byte(i) > most) return 0;
  }
  return lead.bytes;
}

}  // namespace

bool is_valid_utf8(std::string_view text) {
  while (!text.empty()) {
    const size_t bytes = first_character(text);
    if (bytes == 0) return false;
    text.remove_prefix(bytes);
  }
  return true;
}

std::string to_valid_utf8(std::string_view text) {
  if (is_valid_utf8(text)) return std::string(text);
  static constexpr char kHex[] = "0123456789abcdef";
  std::string valid;
  while (!text.empty()) {
    const size_t bytes = first_character(text);
    const auto byte = static_cast<uint8_t>(text[0]);
    if (bytes == 0) {
      valid += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    } else if (text[0] == '\\') {
      valid += "\\\\";
    } else {
      valid += text.substr(0, bytes);
    }
    text.remove_prefix(bytes == 0 ? 1 : bytes);
  }
  return valid;
}

}  // namespace burnish
