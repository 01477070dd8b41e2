#include "client/web/core/stored_png.h"

#include <algorithm>
#include <cstdint>

#include "client/scene/png_note.h"
#include "common/transfer/chunk.h"

namespace burnish {

namespace {

constexpr size_t kBlockBytesMax = 65535;  // of a stored block (RFC 1951)

void add_big_endian(uint32_t value, std::string& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
}

void add_part(std::string_view name, std::string_view data, std::string& png) {
  add_big_endian(static_cast<uint32_t>(data.size()), png);
  const size_t begin = png.size();
  png.append(name).append(data);
  add_big_endian(chunk_crc32(std::string_view(png).substr(begin)), png);
}

uint32_t adler32(std::string_view bytes) {
  constexpr uint32_t kPrime = 65521;
  uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<uint8_t>(c)) % kPrime;
    b = (b + a) % kPrime;
  }
  return b << 16 | a;
}

/// Returns the rows, each behind the number of its filter: none.
std::string rows_of(const Image& image) {
  const size_t row = 3 * static_cast<size_t>(image.size.width);
  std::string rows;
  rows.reserve((row + 1) * static_cast<size_t>(image.size.height));
  for (size_t y = 0; y < static_cast<size_t>(image.size.height); ++y) {
    rows += '\0';
    rows.append(reinterpret_cast<const char*>(image.rgb.data() + y * row), row);
  }
  return rows;
}

/// Returns a zlib stream (RFC 1950) of stored blocks.
std::string stored(const std::string& bytes) {
  std::string stream("\x78\x01", 2);
  for (size_t at = 0; at < bytes.size(); at += kBlockBytesMax) {
    const auto count = static_cast<uint32_t>(std::min(kBlockBytesMax, bytes.size() - at));
    stream += static_cast<char>(at + count == bytes.size());
    for (const uint32_t length : {count, ~count})
      stream += {static_cast<char>(length & 255), static_cast<char>(length >> 8 & 255)};
    stream.append(bytes, at, count);
  }
  add_big_endian(adler32(bytes), stream);
  return stream;
}

}  // namespace

std::string stored_png(const Image& image) {
  std::string head;
  add_big_endian(static_cast<uint32_t>(image.size.width), head);
  add_big_endian(static_cast<uint32_t>(image.size.height), head);
  head += {8, 2, 0, 0, 0};  // 8 bits, RGB, and the only methods that there are
  std::string png("\x89PNG\r\n\x1a\n", 8);
  add_part("IHDR", head, png);
  if (!image.note.empty()) add_part("tEXt", png_note(image.note), png);
  add_part("IDAT", stored(rows_of(image)), png);
  add_part("IEND", "", png);
  return png;
}

}  // namespace burnish
