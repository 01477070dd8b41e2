#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/frame_codec/frame_layout.h"

namespace burnish {

/// A displacement rounded to 1/256 cell, ready for the encoders of all clients of one layout.
struct FrameSample {
  std::vector<int32_t> steps;  ///< tile by tile, in a tile all x, then all y, then all z

  std::span<const int32_t> tile(const FrameLayout& layout, int tile) const {
    return {steps.data() + size_t{3} * layout.tile_begin(tile), size_t{3} * layout.tile_size(tile)};
  }
};

/// Shapes: one displacement per corner of mesh.grid, even if the layout has vertices: E is applied
/// here. Displacement is Vec3d or Vec3f. Units: cells.
/// Fails: internal, naming the first corner or vertex whose displacement is not finite.
template <typename Displacement>
Result<FrameSample> sample_displacement(const FrameLayout& layout, const FrameMesh& mesh,
                                        std::span<const Displacement> corner_displacements);

}  // namespace burnish
