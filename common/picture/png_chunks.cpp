#include "common/picture/png_chunks.h"

namespace burnish {

static constexpr size_t kSignatureBytes = 8, kWordBytes = 4;
static constexpr size_t kFrameBytes = 3 * kWordBytes;  // length, kind and sum

static size_t word_at(std::span<const uint8_t> bytes) {
  return size_t{bytes[0]} << 24 | size_t{bytes[1]} << 16 | size_t{bytes[2]} << 8 | bytes[3];
}

std::vector<PngChunk> list_png_chunks(std::span<const uint8_t> bytes) {
  std::vector<PngChunk> chunks;
  bool is_behind_pixels = false;
  for (size_t at = kSignatureBytes; at < bytes.size() && bytes.size() - at >= kFrameBytes;) {
    const size_t size = word_at(bytes.subspan(at));
    if (size > bytes.size() - at - kFrameBytes) break;
    const auto kind = bytes.subspan(at + kWordBytes, kWordBytes);
    const std::string_view name(reinterpret_cast<const char*>(kind.data()), kind.size());
    if (name == "IEND") break;
    if (name == "IDAT") is_behind_pixels = true;
    if (name != "IDAT" && name != "IHDR")
      chunks.push_back({name, bytes.subspan(at + 2 * kWordBytes, size), is_behind_pixels});
    at += kFrameBytes + size;
  }
  return chunks;
}

}  // namespace burnish
