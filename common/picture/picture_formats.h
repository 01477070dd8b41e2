#pragma once

#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "common/picture/picture.h"

namespace burnish {

/// Private to this folder: a reader for each kind. Messages do not name the file.
Result<Picture> read_png_picture(std::span<const uint8_t> bytes);
Result<Picture> read_jpeg_picture(std::span<const uint8_t> bytes);

/// Fails: invalid_argument if there are no pixels, more than kPicturePixelsMax, or more than a file
/// of this size can mean.
Status check_picture_size(uint64_t width, uint64_t height, uint64_t file_bytes);

}  // namespace burnish
