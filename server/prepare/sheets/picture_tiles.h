#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "common/base/scratch_file.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/texture_wrap.h"
#include "common/picture/picture_rows.h"
#include "common/sheets/push_pull.h"

namespace burnish {

/// Decoded pictures in a scratch file, cut into tiles: no picture is in memory as a whole.
class PictureTiles {
 public:
  static constexpr uint32_t kTileSide = 64;  // texels; at its end a picture has parts of tiles

  /// Needs: the folder exists. Fails: as errno says.
  static Result<PictureTiles> create(const std::filesystem::path& folder, size_t pictures);

  /// Returns the bytes of scratch that a picture takes, and of memory while it is decoded.
  static uint64_t scratch_bytes(const PictureSize& size);
  static uint64_t memory_bytes(const PictureSize& size);

  /// Sizes of a picture; none if it has no texels here.
  struct Place {
    uint64_t begin = 0;  ///< in the file
    uint32_t width = 0;  ///< texels
    uint32_t height = 0;

    bool is_empty() const { return width == 0; }
    uint32_t columns() const { return (width + kTileSide - 1) / kTileSide; }  ///< of tiles
    /// Returns the rows of a tile: fewer than kTileSide in a low picture.
    uint32_t tile_rows() const { return height < kTileSide ? height : kTileSide; }
    uint64_t tile_bytes() const { return uint64_t{kTileSide} * tile_rows() * sizeof(Rgba8); }
    uint64_t band_bytes() const { return columns() * tile_bytes(); }  ///< of a row of tiles
  };
  const Place& place(uint32_t picture) const { return places_[picture]; }

  /// Decodes a picture into its tiles. `admit` hears the size first; `goes_on` is asked for each
  /// row. Fails: as read_picture_rows() and `admit` do; then texels that did not come are white.
  Status decode(uint32_t picture, std::span<const uint8_t> file, const std::string& name,
                const std::function<Status(const PictureSize&)>& admit,
                const std::function<bool()>& goes_on);

  /// Reads a tile. Needs: a tile of the picture; tile_bytes(). Fails: as ScratchFile::read().
  Status read_tile(uint32_t picture, uint32_t column, uint32_t row, std::span<uint8_t> bytes) const;

 private:
  explicit PictureTiles(ScratchFile file, size_t pictures)
      : file_(std::move(file)), places_(pictures) {}
  Status fill_gaps(const Place& place) const;

  ScratchFile file_;
  uint64_t bytes_ = 0;  // reserved
  std::vector<Place> places_;
};

/// Samples pictures for one thread, with the tiles that it used last.
class PictureSampler {
 public:
  explicit PictureSampler(const PictureTiles& tiles) : tiles_(tiles), slots_(kSlots) {}

  /// Returns the picture at a place, in texels from the corner of its first one, filtered by
  /// Catmull-Rom splines. Beyond the borders it goes on as `wraps` says. Needs: a picture with
  /// texels; |x|, |y| < 2^50.
  Texel sample(uint32_t picture, double x, double y, const TextureWraps& wraps);

  /// Returns why a tile could not be read: its texels counted as zero.
  const Status& status() const { return status_; }

 private:
  static constexpr size_t kSlots = 512;  // of 16 KiB
  static constexpr uint32_t kSlotColumns = 32;

  struct Slot {
    uint32_t picture = UINT32_MAX;
    uint32_t column = 0;
    uint32_t row = 0;
    std::vector<Rgba8> texels;
  };
  const Rgba8* tile(uint32_t picture, uint32_t column, uint32_t row);
  Rgba8 texel(uint32_t picture, uint32_t x, uint32_t y);

  const PictureTiles& tiles_;
  std::vector<Slot> slots_;
  Status status_;
};

}  // namespace burnish
