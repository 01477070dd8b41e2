#include "common/picture/picture_kind.h"

#include <algorithm>
#include <array>
#include <string>

#include "common/base/limits.h"

namespace burnish {

static constexpr std::array<uint8_t, 8> kPngMagic = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
static constexpr std::array<uint8_t, 3> kJpegMagic = {0xff, 0xd8, 0xff};

template <size_t kBytes>
static bool begins_with(std::span<const uint8_t> bytes, const std::array<uint8_t, kBytes>& magic) {
  return bytes.size() >= kBytes && std::equal(magic.begin(), magic.end(), bytes.begin());
}

Result<PictureKind> kind_of_picture(std::span<const uint8_t> bytes) {
  if (bytes.size() > kPictureBytesMax)
    return invalid_argument("picture of " + std::to_string(bytes.size()) + " bytes, the limit is " +
                            std::to_string(kPictureBytesMax));
  if (begins_with(bytes, kPngMagic)) return PictureKind::kPng;
  if (begins_with(bytes, kJpegMagic)) return PictureKind::kJpeg;
  return unimplemented("the picture is neither PNG nor JPEG");
}

}  // namespace burnish
