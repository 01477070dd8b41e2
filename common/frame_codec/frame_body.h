#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/frame_codec/frame_layout.h"
#include "common/packing/group_packing.h"

namespace burnish {

/// Collects the sent tiles of one frame. Tiles come in rising order.
class FrameBodyWriter {
 public:
  explicit FrameBodyWriter(const FrameLayout& layout) : sent_(layout.tile_count(), 0) {}

  /// Shapes: all x, then all y, then all z.
  void add_tile(int tile, std::span<const uint32_t> residuals);

  uint32_t sent_tiles() const { return sent_tiles_; }
  size_t byte_count() const;  ///< of bytes()
  std::vector<uint8_t> bytes() const;

 private:
  std::vector<uint8_t> sent_;
  uint32_t sent_tiles_ = 0;
  GroupPacker groups_;
};

/// Reads the tiles back in rising order. Keeps spans of the bytes given to open().
class FrameBodyReader {
 public:
  /// Fails: data_loss if the bytes are not a body of this layout with `sent_tiles` tiles.
  static Result<FrameBodyReader> open(const FrameLayout& layout, uint32_t sent_tiles,
                                      std::span<const uint8_t> bytes);

  bool is_sent(int tile) const { return sent_[tile] != 0; }
  /// Needs: one call for each sent tile, in rising order, with 3 × its size residuals.
  void read_tile(std::span<uint32_t> residuals);

 private:
  FrameBodyReader() = default;

  std::span<const uint8_t> sent_;
  GroupUnpacker groups_;
};

/// Returns the largest size in bytes of a body of the layout.
uint64_t body_bytes_max(const FrameLayout& layout);

}  // namespace burnish
