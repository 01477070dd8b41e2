#pragma once

#include "server/solver/cuda/denoise/filter_views.h"
#include "server/solver/cuda/device/stream.h"

// The twins of common/denoise/normal_layer.cpp and layer_steps.h: the same operations in the same
// order, so the same bits.

namespace burnish::cuda {

/// Writes the offsets and planes of these normals, and moves of 0.
void begin_layer(Stream& stream, const Places& places, const float4* normals,
                 const LayerArrays& arrays);

/// Does measure_centres() for all triangles, then pull_places() for all places.
void update_layer(Stream& stream, const Places& places, const LayerArrays& arrays);

/// Writes the layer of the moves. The corners of triangles that it would turn stay.
void end_layer(Stream& stream, const Places& places, const LayerArrays& arrays);

}  // namespace burnish::cuda
