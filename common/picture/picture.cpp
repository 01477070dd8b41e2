#include "common/picture/picture.h"

#include <algorithm>
#include <array>
#include <new>

#include "common/base/limits.h"
#include "common/picture/picture_formats.h"

namespace burnish {

constexpr std::array<uint8_t, 8> kPngMagic = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::array<uint8_t, 3> kJpegMagic = {0xff, 0xd8, 0xff};

template <size_t kBytes>
static bool begins_with(std::span<const uint8_t> bytes, const std::array<uint8_t, kBytes>& magic) {
  return bytes.size() >= kBytes && std::equal(magic.begin(), magic.end(), bytes.begin());
}

static Result<Picture> decode(std::span<const uint8_t> bytes) {
  if (bytes.size() > kPictureBytesMax)
    return invalid_argument("picture of " + std::to_string(bytes.size()) + " bytes, the limit is " +
                            std::to_string(kPictureBytesMax));
  if (begins_with(bytes, kPngMagic)) return read_png_picture(bytes);
  if (begins_with(bytes, kJpegMagic)) return read_jpeg_picture(bytes);
  return unimplemented("the picture is neither PNG nor JPEG");
}

Status check_picture_size(uint64_t width, uint64_t height, uint64_t file_bytes) {
  const uint64_t pixels_max = std::min(
      kPicturePixelsMax, std::max(kPicturePixelsInAnyCase, file_bytes * kPicturePixelsPerByteMax));
  if (width > 0 && height > 0 && width <= pixels_max / height) return Status::ok();
  return invalid_argument("picture of " + std::to_string(width) + "x" + std::to_string(height) +
                          " pixels; a file of " + std::to_string(file_bytes) +
                          " bytes must have between 1 and " + std::to_string(pixels_max));
}

Result<Picture> read_picture(std::span<const uint8_t> bytes, const std::string& name) {
  try {
    auto picture = decode(bytes);
    if (!picture.is_ok()) return picture.status().with_context(name);
    return picture;
  } catch (const std::bad_alloc&) {
    return resource_exhausted(name + ": not enough memory for its pixels");
  }
}

}  // namespace burnish
