#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

struct ImageSize {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels

  double aspect() const { return static_cast<double>(width) / height; }
  bool operator==(const ImageSize&) const = default;
};

/// Fails: invalid_argument if a side is outside kImageSidePixelsMin..kImageSidePixelsMax.
Status check_image_size(const ImageSize& size);

/// Reads "1280x960". Fails: invalid_argument if `text` is not such a pair, or as above.
Result<ImageSize> parse_image_size(const std::string& text);

/// A picture: three bytes (red, green, blue; sRGB) per pixel, rows from top to bottom.
struct Image {
  ImageSize size;
  std::vector<uint8_t> rgb;
  std::string note = {};  ///< what its file says of it, in ASCII; empty: nothing

  const uint8_t* pixel(int x, int y) const {
    return rgb.data() + 3 * (static_cast<size_t>(y) * size.width + x);
  }
};

}  // namespace burnish
