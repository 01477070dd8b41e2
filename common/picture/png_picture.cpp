#include <png.h>

#include "common/picture/picture_formats.h"

namespace burnish {

static Status png_failure(png_image& header) {
  const Status status = invalid_argument(std::string("libpng: ") + header.message);
  png_image_free(&header);
  return status;
}

Result<Picture> read_png_picture(std::span<const uint8_t> bytes) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()))
    return png_failure(header);
  const Status size = check_picture_size(header.width, header.height, bytes.size());
  if (!size.is_ok()) {
    png_image_free(&header);
    return size;
  }
  header.format = PNG_FORMAT_RGBA;
  header.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  Picture picture{header.width, header.height, {}};
  picture.pixels.resize(size_t{header.width} * header.height);
  if (!png_image_finish_read(&header, nullptr, picture.pixels.data(), 0, nullptr))
    return png_failure(header);
  return picture;
}

}  // namespace burnish
