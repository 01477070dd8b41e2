#include <vector>

#include "common/picture/picture_formats.h"
#include "common/picture/webp_decoding.h"

namespace burnish {

// libwebp needs all pixels in memory.
Status read_webp_rows(std::span<const uint8_t> bytes, const PictureTaker& taker) {
  ASSIGN_OR_RETURN(const WebPBitstreamFeatures features, read_webp_features(bytes));
  const PictureSize size{static_cast<uint32_t>(features.width),
                         static_cast<uint32_t>(features.height), webp_decoding_bytes(features)};
  RETURN_IF_ERROR(begin_picture(size, bytes.size(), taker));
  std::vector<Rgba8> pixels(size_t{size.width} * size.height);
  RETURN_IF_ERROR(decode_webp_pixels(bytes, features, taker.goes_on, pixels));
  for (uint32_t y = 0; y < size.height; ++y) {
    if (taker.goes_on && !taker.goes_on()) return cancelled("decoding was cancelled");
    taker.take({y, 0, 1, std::span(pixels).subspan(size_t{y} * size.width, size.width)});
  }
  return Status::ok();
}

}  // namespace burnish
