#include "client/web/core/picture_address.h"

#include <cstdint>
#include <string_view>

#include "client/web/core/stored_png.h"

namespace burnish {

// RFC 4648, section 4.
static void add_base64(std::string_view bytes, std::string& text) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t at = 0; at < bytes.size(); at += 3) {
    uint32_t bits = 0;
    for (size_t i = at; i < at + 3; ++i)
      bits = bits << 8 | (i < bytes.size() ? static_cast<uint8_t>(bytes[i]) : 0U);
    for (size_t digit = 0; digit < 4; ++digit)
      text += at + digit <= bytes.size() ? kDigits[bits >> (18 - 6 * digit) & 63] : '=';
  }
}

std::string picture_address(const Image& image) {
  std::string address = "data:image/png;base64,";
  add_base64(stored_png(image), address);
  return address;
}

}  // namespace burnish
