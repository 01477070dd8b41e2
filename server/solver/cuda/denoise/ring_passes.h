#pragma once

#include "server/solver/cuda/denoise/filter_views.h"
#include "server/solver/cuda/device/stream.h"

// The twins of common/denoise/ring_sums.h: the same operations in the same order, so the same bits.

namespace burnish::cuda {

/// Does sum_rings() for all triangles.
void sum_rings(Stream& stream, const Rings& rings, const float4* normals, const float4* guides,
               float steepness, float4* out);

/// Does measure_rings().
void measure_rings(Stream& stream, const Rings& rings, const float4* normals, float4* measured);

/// Does pick_rings().
void pick_rings(Stream& stream, const Rings& rings, const float4* measured, float sharpness,
                float4* guides);

/// Leaves out the areas.
void take_normals(Stream& stream, int64_t count, const float4* normals, Float3* out);

}  // namespace burnish::cuda
