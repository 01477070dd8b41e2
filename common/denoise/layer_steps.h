#pragma once

#include <cstddef>
#include <cstdint>

#include "common/base/types.h"
#include "common/denoise/triangle_normals.h"

namespace burnish {

/// A surface whose places move, as the hot loops take it. Lengths are in one unit, about an edge:
/// moves are small beside coordinates, so floats do. Pointers are not null and stay the caller's.
struct LayerField {
  const Triangle* triangles;   ///< of places
  const uint64_t* fan_starts;  ///< per place and one past the last, into the next two
  const uint32_t* fans;        ///< triangles at each place
  /// The way from the place to the triangle's centre along its normal, times the root of its area.
  const float* offsets;
  /// Per triangle the wanted normal, and how far its centre has moved along it; all four times the
  /// root of its area.
  Float4* planes;
  Float4* moves;  ///< per place; beside it one over the areas of its triangles, or 0
};

/// Measures how far the centres of triangles `begin` to `end` have moved.
void measure_centres(const LayerField& field, size_t begin, size_t end);

/// Moves places `begin` to `end` by the mean way to the planes of their triangles, by area.
void pull_places(const LayerField& field, size_t begin, size_t end);

}  // namespace burnish
