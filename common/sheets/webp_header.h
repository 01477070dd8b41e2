#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// Checks that a WebP's header says this size and codec, and one frame, without decoding anything.
/// Safe for any bytes. Fails: data_loss that names the damage.
Status check_webp(std::span<const uint8_t> bytes, uint32_t width, uint32_t height,
                  SheetCodec codec);

/// Returns the frame alone, in a container without its alpha plane, profile and notes: decoders of
/// others then return the same texels, and see nothing that is not checked. Safe for any bytes.
/// Fails: as check_webp() does, also where the frame has another size than the container.
Result<std::vector<uint8_t>> opaque_webp(std::span<const uint8_t> bytes, uint32_t width,
                                         uint32_t height, SheetCodec codec);

}  // namespace burnish
