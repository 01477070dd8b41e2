#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/textures/texture_wrap.h"
#include "common/sheets/push_pull.h"
#include "server/prepare/sheets/picture_tiles.h"

namespace burnish {

/// Samples pictures for one thread, with the tiles that it used last.
class PictureSampler {
 public:
  explicit PictureSampler(const PictureTiles& tiles) : tiles_(tiles), slots_(kSlots) {}

  /// Returns a level of a picture at a place, in texels from the corner of its first one, filtered
  /// by Catmull-Rom splines. Beyond the borders it goes on as `wraps` says. Needs: a level of the
  /// tiles; |x|, |y| < 2^50.
  Texel sample(const TiledLevel& level, double x, double y, const TextureWraps& wraps);

  /// Returns why a tile could not be read: its texels counted as zero.
  const Status& status() const { return status_; }

 private:
  static constexpr size_t kSlots = 512;  // of 16 KiB
  static constexpr uint32_t kSlotColumns = 32;

  struct Slot {
    const TiledLevel* level = nullptr;
    uint32_t column = 0;
    uint32_t row = 0;
    std::vector<Rgba8> texels;
  };
  const Rgba8* tile(const TiledLevel& level, uint32_t column, uint32_t row);
  Rgba8 texel(const TiledLevel& level, uint32_t x, uint32_t y);

  const PictureTiles& tiles_;
  std::vector<Slot> slots_;
  Status status_;
};

}  // namespace burnish
