#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/sheets/webp_header.h"

namespace burnish {

inline constexpr float kSheetQuality = 90;  // of lossy WebP, 0..100

/// Packs texels, row by row, as one WebP. The same texels give the same bytes. Keeps the colours
/// of transparent texels, for sheets are drawn opaque.
/// Needs: width * height texels; sides of 1..kSheetSideMax. Fails: resource_exhausted.
Result<std::vector<uint8_t>> encode_webp(std::span<const Rgba8> texels, uint32_t width,
                                         uint32_t height, SheetCodec codec);

/// Unpacks a WebP whose header says exactly this. Safe for any bytes: the header is compared before
/// anything is decoded or memory is taken. Fails: data_loss that names the damage.
Result<std::vector<Rgba8>> decode_webp(std::span<const uint8_t> bytes, uint32_t width,
                                       uint32_t height, SheetCodec codec);

}  // namespace burnish
