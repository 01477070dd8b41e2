#include "client/web/core/picture_address.h"

#include <string>

#include <gtest/gtest.h>

#include "client/web/core/stored_png.h"

namespace burnish {
namespace {

/// Returns the bytes of base64 text, as RFC 4648 has them.
std::string bytes_of(const std::string& text) {
  static const std::string kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char digit : text) {
    if (digit == '=') break;
    bits = bits << 6 | static_cast<unsigned>(kDigits.find(digit));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

TEST(PictureAddress, HoldsThePngForAnyNumberOfBytes) {
  static const std::string kBegin = "data:image/png;base64,";
  for (int width = 1; width <= 3; ++width) {  // each rest of a division by three
    Image image{{width, 1}, {}};
    for (int i = 0; i < 3 * width; ++i) image.rgb.push_back(static_cast<uint8_t>(255 - 40 * i));
    const std::string address = picture_address(image);
    ASSERT_TRUE(address.starts_with(kBegin)) << address;
    EXPECT_EQ(address.size() % 4, kBegin.size() % 4);
    EXPECT_EQ(bytes_of(address.substr(kBegin.size())), stored_png(image));
  }
}

}  // namespace
}  // namespace burnish
