#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/base/limits.h"
#include "common/base/status.h"

namespace burnish {

struct ImageSize {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels

  double aspect() const { return static_cast<double>(width) / height; }
  bool operator==(const ImageSize&) const = default;
};

/// Fails: invalid_argument if a side is outside kImageSidePixelsMin..kImageSidePixelsMax.
inline Status check_image_size(const ImageSize& size) {
  const auto is_outside = [](int side) {
    return side < kImageSidePixelsMin || side > kImageSidePixelsMax;
  };
  if (!is_outside(size.width) && !is_outside(size.height)) return Status::ok();
  return invalid_argument("picture of " + std::to_string(size.width) + "x" +
                          std::to_string(size.height) + " pixels: both sides must be within " +
                          std::to_string(kImageSidePixelsMin) + ".." +
                          std::to_string(kImageSidePixelsMax));
}

/// A picture: three bytes (red, green, blue; sRGB) per pixel, rows from top to bottom.
struct Image {
  ImageSize size;
  std::vector<uint8_t> rgb;

  const uint8_t* pixel(int x, int y) const {
    return rgb.data() + 3 * (static_cast<size_t>(y) * size.width + x);
  }
};

}  // namespace burnish
