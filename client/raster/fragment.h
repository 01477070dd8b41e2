#pragma once

#include <array>

#include "client/raster/shaded_scene.h"
#include "client/raster/visibility.h"

namespace burnish {

/// The part of a pixel that one triangle covers.
struct Fragment {
  uint32_t id = 0;   ///< triangle_id()
  int x = 0, y = 0;  ///< the pixel
  int samples = 0;   ///< bits of the covered ones
};

/// How many edges of the triangle cover each sample, for the view of triangles.
using EdgeCounts = std::array<uint8_t, kSamplesMax>;

/// Ask memory for a fragment's triangle, and then for its corners. Pixels beside each other show
/// triangles that are far apart in memory.
void prefetch_triangle(const ShadedScene& scene, const Fragment& fragment);
void prefetch_corners(const ShadedScene& scene, const Fragment& fragment);

/// Puts what the light needs of a fragment into place batch.count of a batch, and counts that.
/// Interpolates as the shaders of client/gl have it: with perspective, at the middle of the pixel,
/// or at its first covered sample if others are not.
void add_fragment(const ShadedScene& scene, const SamplePlaces& places, const Fragment& fragment,
                  ShadeBatch& batch, EdgeCounts& edges);

}  // namespace burnish
