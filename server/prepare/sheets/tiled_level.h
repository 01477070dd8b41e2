#pragma once

#include <algorithm>
#include <cstdint>

#include "common/base/types.h"

namespace burnish {

inline constexpr uint32_t kTileSide = 64;  // texels; at its end a picture has parts of tiles

/// A level of a picture in a file, cut into tiles: a band, a row of tiles, lies behind the other.
struct TiledLevel {
  uint64_t begin = 0;  ///< in the file
  uint32_t width = 0;  ///< texels
  uint32_t height = 0;

  uint32_t columns() const { return (width + kTileSide - 1) / kTileSide; }  ///< of tiles
  /// Returns the rows of a tile: fewer than kTileSide in a low picture.
  uint32_t tile_rows() const { return std::min(height, kTileSide); }
  uint64_t tile_bytes() const { return uint64_t{kTileSide} * tile_rows() * sizeof(Rgba8); }
  uint64_t band_bytes() const { return columns() * tile_bytes(); }
  uint64_t end() const { return begin + (height + tile_rows() - 1) / tile_rows() * band_bytes(); }
};

}  // namespace burnish
