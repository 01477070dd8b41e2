#include "common/sheets/webp_header.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace burnish {

namespace {

/// Reads little-endian numbers at their places in a WebP file.
class WebpBytes {
 public:
  explicit WebpBytes(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  uint32_t number(size_t at, size_t count) const {
    uint32_t value = 0;
    for (size_t i = 0; i < count; ++i) value |= uint32_t{bytes_[at + i]} << 8 * i;
    return value;
  }
  bool has(size_t at, std::string_view text) const {
    return std::equal(text.begin(), text.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char c, uint8_t byte) { return static_cast<uint8_t>(c) == byte; });
  }

 private:
  std::span<const uint8_t> bytes_;
};

constexpr uint32_t kSideBits = (1u << 14) - 1;
constexpr size_t kContainerBytes = 12;   // RIFF, its size, WEBP
constexpr size_t kChunkHeaderBytes = 8;  // a name, a size

Result<WebpHeader> lossy_header(const WebpBytes& bytes) {
  if (!bytes.has(23, "\x9d\x01\x2a")) return data_loss("its VP8 frame has no start code");
  return WebpHeader{.codec = SheetCodec::kLossyWebp,
                    .width = bytes.number(26, 2) & kSideBits,
                    .height = bytes.number(28, 2) & kSideBits};
}

Result<WebpHeader> lossless_header(const WebpBytes& bytes) {
  if (!bytes.has(20, "\x2f")) return data_loss("its VP8L frame has no signature");
  const uint32_t bits = bytes.number(21, 4);
  return WebpHeader{.codec = SheetCodec::kLosslessWebp,
                    .width = (bits & kSideBits) + 1,
                    .height = (bits >> 14 & kSideBits) + 1};
}

WebpHeader extended_header(const WebpBytes& bytes) {
  constexpr uint32_t kAnimation = 2;
  return {.codec = SheetCodec::kLossyWebp,
          .width = bytes.number(24, 3) + 1,
          .height = bytes.number(27, 3) + 1,
          .is_animated = (bytes.number(20, 1) & kAnimation) != 0};
}

/// Returns the first chunk of texels; empty if there is none.
std::span<const uint8_t> frame_of(std::span<const uint8_t> bytes) {
  const WebpBytes file(bytes);
  for (size_t at = kContainerBytes; at + kChunkHeaderBytes <= bytes.size();) {
    const uint64_t content = file.number(at + 4, 4);
    const uint64_t chunk = kChunkHeaderBytes + content + content % 2;
    if (chunk > bytes.size() - at) break;
    if (file.has(at, "VP8 ") || file.has(at, "VP8L")) return bytes.subspan(at, chunk);
    at += chunk;
  }
  return {};
}

std::string size_text(uint32_t width, uint32_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

Result<WebpHeader> read_webp_header(std::span<const uint8_t> bytes) {
  if (bytes.size() < kWebpHeaderBytes)
    return data_loss("the WebP has " + std::to_string(bytes.size()) + " bytes, its header needs " +
                     std::to_string(kWebpHeaderBytes));
  const WebpBytes header(bytes);
  if (!header.has(0, "RIFF") || !header.has(8, "WEBP"))
    return data_loss("the texels do not begin with RIFF and WEBP");
  const uint64_t riff_bytes = uint64_t{header.number(4, 4)} + 8;
  if (riff_bytes != bytes.size())
    return data_loss("the WebP says " + std::to_string(riff_bytes) + " bytes, it has " +
                     std::to_string(bytes.size()));
  if (header.has(12, "VP8 ")) return lossy_header(header);
  if (header.has(12, "VP8L")) return lossless_header(header);
  if (header.has(12, "VP8X")) return extended_header(header);
  return data_loss("the WebP begins with none of the chunks VP8, VP8L and VP8X");
}

Status check_webp(std::span<const uint8_t> bytes, uint32_t width, uint32_t height,
                  SheetCodec codec) {
  ASSIGN_OR_RETURN(const WebpHeader header, read_webp_header(bytes));
  if (header.is_animated) return data_loss("the WebP is animated, a sheet has one frame");
  if (header.width != width || header.height != height)
    return data_loss("the WebP has " + size_text(header.width, header.height) +
                     " texels, the sheet " + size_text(width, height));
  if (header.codec != codec)
    return data_loss("the WebP has codec " + std::to_string(static_cast<int>(header.codec)) +
                     ", the sheet " + std::to_string(static_cast<int>(codec)));
  return Status::ok();
}

Result<std::vector<uint8_t>> opaque_webp(std::span<const uint8_t> bytes, uint32_t width,
                                         uint32_t height, SheetCodec codec) {
  RETURN_IF_ERROR(check_webp(bytes, width, height, codec));
  const std::span<const uint8_t> frame = frame_of(bytes);
  std::vector<uint8_t> alone(bytes.begin(), bytes.begin() + kContainerBytes);
  alone.insert(alone.end(), frame.begin(), frame.end());
  const auto rest = static_cast<uint32_t>(alone.size() - kChunkHeaderBytes);
  for (size_t i = 0; i < 4; ++i) alone[4 + i] = static_cast<uint8_t>(rest >> 8 * i);
  RETURN_IF_ERROR(check_webp(alone, width, height, codec));
  return alone;
}

}  // namespace burnish
