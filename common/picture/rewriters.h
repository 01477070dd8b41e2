#pragma once

#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "common/picture/picture_rewriter.h"

namespace burnish {

inline constexpr uint32_t kEditedRows = 128;  // of a band; whole MCUs of most JPEG files

/// Private to this folder: a rewriter for each kind. Messages do not name the file.
Result<RewrittenPicture> rewrite_png(std::span<const uint8_t> bytes, const PictureEditor& editor);
Result<RewrittenPicture> rewrite_jpeg(std::span<const uint8_t> bytes, const PictureEditor& editor);
Result<RewrittenPicture> rewrite_webp(std::span<const uint8_t> bytes, const PictureEditor& editor);

/// Returns the grey of a colour, as JPEG has it; the same for three equal channels.
inline uint16_t grey_of(const FileTexel& texel) {
  return static_cast<uint16_t>((299u * texel[0] + 587u * texel[1] + 114u * texel[2] + 500) / 1000);
}

}  // namespace burnish
