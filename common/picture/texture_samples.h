#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/base/types.h"
#include "common/picture/picture_rows.h"
#include "common/picture/sample_texture.h"

namespace burnish {

/// The pixels that some texture coordinates need, gathered from runs in any order. Takes 56 bytes
/// for a coordinate, whatever the picture's size.
class TextureSamples {
 public:
  explicit TextureSamples(size_t coordinates);

  /// Wants the pixels of the next coordinate.
  void add(const PixelSquare& at);

  /// Call once after the last add().
  void sort();

  /// Keeps what a run has of these pixels.
  void take(const PixelRun& run);

  /// The four pixels of a coordinate, in the order of mixed_colour(). Needs: all runs.
  const std::array<Rgba8, 4>& pixels(size_t coordinate) const { return pixels_[coordinate]; }

 private:
  /// Two pixels of a coordinate in one row.
  struct Visit {
    uint32_t y;
    uint32_t x[2];
    uint32_t coordinate;
    uint32_t into;  ///< 0 for the first row, 2 for the second
  };

  std::vector<Visit> visits_;  // by row
  std::vector<std::array<Rgba8, 4>> pixels_;
};

}  // namespace burnish
