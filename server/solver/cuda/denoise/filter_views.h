#pragma once

#include <cstdint>
#include <vector_types.h>

#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// TriangleRings, and what pairs weigh by place (common/denoise/ring_nearness.h).
struct Rings {
  int64_t count;  ///< of triangles
  const uint64_t* start;
  const uint32_t* triangle;
  const float* nearness;
};

/// The places of a triangle's corners.
struct Corners {
  uint32_t at[3];
};

struct Float3 {
  float x, y, z;
};

/// WeldedSurface, and the length that moves are measured in.
struct Places {
  int64_t triangle_count;
  int64_t count;  ///< of vertices, whether they name a place or not
  const Corners* triangles;
  const uint8_t* is_surface;
  const uint64_t* fan_start;
  const uint32_t* fans;
  const uint32_t* place;  ///< of each vertex
  const Double3* at;
  double unit;
};

/// The arrays of LayerField; and the layer, and which triangles it turns.
struct LayerArrays {
  float* offsets;
  float4* planes;
  float4* moves;
  Float3* layer;
  uint8_t* turned;
};

}  // namespace burnish::cuda
