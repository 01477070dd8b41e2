#include "common/picture/picture_rows.h"

#include <algorithm>
#include <new>
#include <optional>

#include "common/base/limits.h"
#include "common/picture/picture_formats.h"
#include "common/picture/picture_kind.h"

namespace burnish {

static Status decode(std::span<const uint8_t> bytes, const PictureTaker& taker) {
  ASSIGN_OR_RETURN(const PictureKind kind, kind_of_picture(bytes));
  if (kind == PictureKind::kWebp) return read_webp_rows(bytes, taker);
  return kind == PictureKind::kPng ? read_png_rows(bytes, taker) : read_jpeg_rows(bytes, taker);
}

static std::string in_words(const PictureSize& size) {
  return "picture of " + std::to_string(size.width) + "x" + std::to_string(size.height) + " pixels";
}

Status begin_picture(const PictureSize& size, uint64_t file_bytes, const PictureTaker& taker) {
  const uint64_t pixels_max = std::min(
      kPicturePixelsMax, std::max(kPicturePixelsInAnyCase, file_bytes * kPicturePixelsPerByteMax));
  if (size.width == 0 || size.height == 0 || size.width > pixels_max / size.height)
    return invalid_argument(in_words(size) + "; a file of " + std::to_string(file_bytes) +
                            " bytes must have between 1 and " + std::to_string(pixels_max));
  return taker.begin(size).with_context(in_words(size));
}

Status read_picture_rows(std::span<const uint8_t> bytes, const std::string& name,
                         const PictureTaker& taker) {
  try {
    return decode(bytes, taker).with_context(name);
  } catch (const std::bad_alloc&) {
    return resource_exhausted(name + ": not enough memory for its pixels");
  }
}

Result<PictureSize> read_picture_size(std::span<const uint8_t> bytes, const std::string& name) {
  std::optional<PictureSize> size;
  const auto begin = [&](const PictureSize& announced) {
    size = announced;
    return cancelled("the size is all");
  };
  const Status status = read_picture_rows(bytes, name, {begin, [](const PixelRun&) {}});
  if (size) return *size;
  return status;
}

}  // namespace burnish
