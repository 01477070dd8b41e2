#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/scratch_file.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/picture/picture_rows.h"
#include "server/prepare/sheets/tiled_level.h"

namespace burnish {

/// One band of a level in memory.
class TextureBand {
 public:
  /// Needs: the file outlives this.
  TextureBand(const ScratchFile& file, const TiledLevel& level);

  Status read(int64_t band);
  Status write() const;
  void clear(int64_t band);

  /// The band that is here; -1: none.
  int64_t number() const { return number_; }
  int64_t number_of(uint32_t y) const { return y / level_.tile_rows(); }

  /// Needs: number_of(y) is here.
  Rgba8& at(uint32_t x, uint32_t y) { return texels_[index(x, y)]; }
  const Rgba8& at(uint32_t x, uint32_t y) const { return texels_[index(x, y)]; }
  std::span<Rgba8> texels() { return texels_; }

 private:
  size_t index(uint32_t x, uint32_t y) const {
    const size_t tile = x / kTileSide * (level_.tile_bytes() / sizeof(Rgba8));
    return tile + size_t{y % level_.tile_rows()} * kTileSide + x % kTileSide;
  }
  uint64_t offset() const {
    return level_.begin + static_cast<uint64_t>(number_) * level_.band_bytes();
  }

  const ScratchFile& file_;
  const TiledLevel level_;
  std::vector<Rgba8> texels_;
  int64_t number_ = -1;
};

/// Puts the rows of a picture into its tiles.
class BandWriter {
 public:
  BandWriter(const ScratchFile& file, const TiledLevel& level) : band_(file, level) {}

  /// Fails: as ScratchFile says.
  Status put(const PixelRun& run);
  /// Call it last.
  Status flush();

 private:
  Status go_to(int64_t number);

  TextureBand band_;
  int64_t last_ = -1;  // that was written
};

/// Returns the texels' bytes.
inline std::span<uint8_t> as_bytes(std::span<Rgba8> texels) {
  return {reinterpret_cast<uint8_t*>(texels.data()), texels.size_bytes()};
}

}  // namespace burnish
