#pragma once

#include <cstddef>
#include <cstdint>

#include "common/denoise/triangle_normals.h"

namespace burnish {

/// Returns what sum_rings() takes for σ.
inline float steepness_of(double sigma) {
  return static_cast<float>(1 / (sigma * sigma));
}

/// Rings and what is known of each triangle, as the hot loops take them. Pointers are not null and
/// stay the caller's.
struct RingField {
  const uint64_t* starts;
  const uint32_t* triangles;
  const NormalAndArea* normals;
};

/// Writes for triangles `begin` to `end` the mean normal of the ring and the triangle itself, by
/// area, pairs by `nearness` and exp(-|guide_t - guide_j|² / 2σ²) with `steepness` 1/σ². The area
/// stays; a normal stays where the mean has no direction.
void sum_rings(const RingField& field, const float* nearness, const Float4* guides, float steepness,
               size_t begin, size_t end, NormalAndArea* out);

/// Writes for triangles `begin` to `end` the mean normal of the ring and the triangle itself, by
/// area, and beside it how uneven they are: 0 where all normals agree.
void measure_rings(const RingField& field, size_t begin, size_t end, Float4* out);

/// Writes for triangles `begin` to `end` the normal of the most even ring around. All rings around
/// count, by exp(-sharpness times their unevenness) beside the least one's.
void pick_rings(const RingField& field, const Float4* measured, float sharpness, size_t begin,
                size_t end, Float4* out);

}  // namespace burnish
