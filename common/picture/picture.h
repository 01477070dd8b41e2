#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// A picture in memory: sRGB with alpha, row by row from the top.
struct Picture {
  uint32_t width = 0;         ///< pixels
  uint32_t height = 0;        ///< pixels
  std::vector<Rgba8> pixels;  ///< width * height

  const Rgba8& at(uint32_t x, uint32_t y) const { return pixels[size_t{y} * width + x]; }
};

/// Decodes a small PNG, JPEG or WebP file into memory. Fails: as read_picture_rows().
Result<Picture> read_picture(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace burnish
