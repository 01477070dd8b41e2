#pragma once

namespace burnish::cuda {

/// Returns the weight of corner a of a cell at one of its 3×3×3 half-way points.
__device__ inline float half_way_weight(int place, int a) {
  float weight = 1;
#pragma unroll
  for (int axis = 0; axis < 3; ++axis, place /= 3) {
    const float high = 0.5f * static_cast<float>(place % 3);
    weight *= a >> axis & 1 ? high : 1 - high;
  }
  return weight;
}

}  // namespace burnish::cuda
