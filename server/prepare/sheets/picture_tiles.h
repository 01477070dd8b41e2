#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "common/base/scratch_file.h"
#include "common/base/status.h"
#include "common/picture/picture_rows.h"
#include "server/prepare/sheets/tiled_level.h"

namespace burnish {

/// Decoded pictures in a scratch file, cut into tiles: no picture is in memory as a whole. Each has
/// levels: level 0 is the picture, and each further one the means of 2 x 2 texels, down to one
/// texel.
class PictureTiles {
 public:
  /// Needs: the folder exists. Fails: as errno says.
  static Result<PictureTiles> create(const std::filesystem::path& folder, size_t pictures);

  /// Returns the bytes of scratch that a picture takes, and of memory while it is decoded.
  static uint64_t scratch_bytes(const PictureSize& size);
  static uint64_t memory_bytes(const PictureSize& size);

  /// Returns the levels of a picture; none if it has no texels here.
  std::span<const TiledLevel> levels(uint32_t picture) const { return levels_[picture]; }
  bool has(uint32_t picture) const { return !levels_[picture].empty(); }

  uint64_t bytes() const { return bytes_; }  ///< of scratch

  /// Decodes a picture into its tiles. `admit` hears the size first; `goes_on` is asked for each
  /// row. Fails: as read_picture_rows() and `admit` do; then texels that did not come are white.
  Status decode(uint32_t picture, std::span<const uint8_t> file, const std::string& name,
                const std::function<Status(const PictureSize&)>& admit,
                const std::function<bool()>& goes_on);

  /// Reads a tile. Needs: a tile of the level; tile_bytes(). Fails: as ScratchFile::read().
  Status read_tile(const TiledLevel& level, uint32_t column, uint32_t row,
                   std::span<uint8_t> bytes) const;

 private:
  explicit PictureTiles(ScratchFile file, size_t pictures)
      : file_(std::move(file)), levels_(pictures) {}
  Status fill_gaps(const TiledLevel& place) const;
  Status halve(const TiledLevel& finer, const TiledLevel& coarser,
               const std::function<bool()>& goes_on) const;

  ScratchFile file_;
  uint64_t bytes_ = 0;                           // reserved
  std::vector<std::vector<TiledLevel>> levels_;  // by picture
};

}  // namespace burnish
