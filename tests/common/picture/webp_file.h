#pragma once

#include <cstdint>
#include <string>

#include <webp/encode.h>

#include "common/picture/picture.h"

namespace burnish {

/// Returns the picture as a WebP file, without loss or of high quality.
inline std::string webp_of(const Picture& picture, bool is_lossless = true) {
  const auto width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
  const uint8_t* const pixels = picture.pixels[0].data();
  uint8_t* bytes = nullptr;
  const size_t size = is_lossless ? WebPEncodeLosslessRGBA(pixels, width, height, 4 * width, &bytes)
                                  : WebPEncodeRGBA(pixels, width, height, 4 * width, 95, &bytes);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  WebPFree(bytes);
  return file;
}

}  // namespace burnish
