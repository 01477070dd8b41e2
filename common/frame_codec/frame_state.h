#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/frame_codec/frame_layout.h"

namespace burnish {

/// What a client holds after a frame: the values of all tiles, in 1/256 cell. Copies share the
/// tiles that no frame between them sent, so that remembering a few frames costs little.
class FrameState {
 public:
  /// All zero: what a key frame starts from.
  explicit FrameState(const FrameLayout& layout) : tiles_(layout.tile_count()) {}

  /// Copies a tile out: all x, then all y, then all z. Needs: values.size() is 3 × the tile's size.
  void read_tile(int tile, std::span<int32_t> values) const;
  void write_tile(int tile, std::span<const int32_t> values);

  /// True where the two hold the same tile because neither has changed it since they were one.
  bool shares_tile(const FrameState& other, int tile) const {
    return tiles_[tile] == other.tiles_[tile];
  }

  uint64_t byte_count() const;  ///< shared tiles included

  /// What byte_count() stays within while displacements are below 128 cells.
  static uint64_t byte_count_max(const FrameLayout& layout);

 private:
  // Two bytes a value as long as they fit: displacements below 128 cells.
  struct Tile {
    std::vector<int16_t> narrow;
    std::vector<int32_t> wide;
  };
  std::vector<std::shared_ptr<const Tile>> tiles_;  // null: all zero
};

/// Writes the displacement of one tile's values to where they belong. Shapes: one per corner, or
/// per vertex, as layout.content says; what no frame carries is left alone. Units: cells.
void write_displacement(const FrameLayout& layout, const FrameState& state, int tile,
                        std::span<Vec3f> displacements);

}  // namespace burnish
