#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/base/status.h"

namespace burnish {

/// How the texels of a sheet are coded.
enum class SheetCodec : uint8_t {
  kLossyWebp = 1,  ///< with an alpha plane only where a texel has one below 255
  kLosslessWebp = 2,
};

/// The facts that the first bytes of a WebP file say.
struct WebpHeader {
  SheetCodec codec = SheetCodec::kLossyWebp;
  uint32_t width = 0;   ///< texels
  uint32_t height = 0;  ///< texels
  bool is_animated = false;
};
inline constexpr size_t kWebpHeaderBytes = 30;

/// Reads the first 30 bytes without decoding anything (RFC 9649, sections 2.3 to 2.7). Takes one
/// RIFF container that fills the bytes, whose first chunk is VP8, VP8L or VP8X.
/// Fails: data_loss that names the damage.
Result<WebpHeader> read_webp_header(std::span<const uint8_t> bytes);

}  // namespace burnish
