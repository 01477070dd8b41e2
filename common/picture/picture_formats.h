#pragma once

#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "common/picture/picture_rows.h"

namespace burnish {

/// Private to this folder: a reader for each kind. Messages do not name the file.
Status read_png_rows(std::span<const uint8_t> bytes, const PictureTaker& taker);
Status read_jpeg_rows(std::span<const uint8_t> bytes, const PictureTaker& taker);
Status read_webp_rows(std::span<const uint8_t> bytes, const PictureTaker& taker);

/// Fails: invalid_argument if there are no pixels, more than kPicturePixelsMax, or more than a file
/// of this size can mean; as the taker's begin() does.
Status begin_picture(const PictureSize& size, uint64_t file_bytes, const PictureTaker& taker);

}  // namespace burnish
