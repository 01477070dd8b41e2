#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include <webp/decode.h>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// Private to this folder. Reads a WebP file's header. Fails: invalid_argument (damaged);
/// unimplemented (animated).
Result<WebPBitstreamFeatures> read_webp_features(std::span<const uint8_t> bytes);

/// Returns the memory that a decoder takes, its pixels with it.
uint64_t webp_decoding_bytes(const WebPBitstreamFeatures& features);

/// Decodes all pixels: width * height. `goes_on` is asked between parts of the file; null: it goes
/// on. Fails: invalid_argument (damaged, cut off); resource_exhausted; cancelled.
Status decode_webp_pixels(std::span<const uint8_t> bytes, const WebPBitstreamFeatures& features,
                          const std::function<bool()>& goes_on, std::span<Rgba8> pixels);

}  // namespace burnish
