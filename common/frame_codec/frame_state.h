#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/frame_codec/frame_layout.h"
#include "common/packing/narrow_values.h"

namespace burnish {

/// A client's state after a frame: the values of all tiles, in 1/256 cell. Copies share the tiles
/// that no frame between them sent, so remembering a few frames costs little.
class FrameState {
 public:
  /// Makes the state that a key frame starts from: all zero.
  explicit FrameState(const FrameLayout& layout) : tiles_(layout.tile_count()) {}

  /// Copies a tile out: all x, then all y, then all z. Needs: values.size() is 3 × the tile's size.
  void read_tile(int tile, std::span<int32_t> values) const;
  void write_tile(int tile, std::span<const int32_t> values);

  /// Returns true if neither state has changed the tile since one was copied from the other.
  bool shares_tile(const FrameState& other, int tile) const {
    return tiles_[tile] == other.tiles_[tile];
  }

  uint64_t byte_count() const;  ///< shared tiles included

  /// Returns the limit of byte_count() while displacements are below 128 cells.
  static uint64_t byte_count_max(const FrameLayout& layout);

 private:
  std::vector<std::shared_ptr<const NarrowValues>> tiles_;  // null: all zero
};

/// Writes the displacements of one tile to their corners or vertices, as layout.content says.
/// Entries that no frame carries are left alone. Shapes: one per corner or per vertex. Units:
/// cells.
void write_displacement(const FrameLayout& layout, const FrameState& state, int tile,
                        std::span<Vec3f> displacements);

}  // namespace burnish
