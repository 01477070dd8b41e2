#include "server/solver/cuda/kernel.h"
#include "server/solver/cuda/transfer.h"

namespace burnish::cuda {

namespace {

__global__ void residual_kernel(Depth depth) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= depth.topology.corner_count) return;
  const auto corner = static_cast<int32_t>(i);
  depth.r[i] = depth.inverse_diagonal[i] == 0
                   ? zero4()
                   : depth.f[i] - product_row(depth.topology.rows, depth.system, depth.x, corner);
}

__global__ void restrict_kernel(Depth fine, Depth coarse) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= coarse.topology.corner_count) return;
  float4 sum = zero4();
  const int64_t end = fine.topology.restriction_start[i + 1];
  for (int64_t k = fine.topology.restriction_start[i]; k < end; k += kChunk) {
    int32_t corner[kChunk];
    float weight[kChunk];
#pragma unroll
    for (int j = 0; j < kChunk; ++j) {
      corner[j] = k + j < end ? fine.topology.restriction_corner[k + j] : 0;
      weight[j] = k + j < end ? fine.topology.restriction_weight[k + j] : 0;
    }
#pragma unroll
    for (int j = 0; j < kChunk; ++j) sum = sum + weight[j] * fine.r[corner[j]];
  }
  coarse.f[i] = coarse.inverse_diagonal[i] > 0 ? sum : zero4();
}

// The weight of corner a of a cell at one of its 3×3×3 half-way points.
__device__ float half_way_weight(int place, int a) {
  float weight = 1;
#pragma unroll
  for (int axis = 0; axis < 3; ++axis, place /= 3) {
    const float high = 0.5f * static_cast<float>(place % 3);
    weight *= a >> axis & 1 ? high : 1 - high;
  }
  return weight;
}

__global__ void prolong_kernel(Depth coarse, Depth fine) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= fine.topology.corner_count || fine.inverse_diagonal[i] == 0) return;
  const FromCell from = fine.topology.prolongation[i];
  float4 sum = fine.x[i];
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const float weight = half_way_weight(from.place, a);
    if (weight > 0) sum = sum + weight * coarse.x[coarse.topology.cell_corners[from.cell].at[a]];
  }
  fine.x[i] = sum;
}

}  // namespace

void compute_residual(Stream& stream, const Depth& depth) {
  launch(stream, residual_kernel, depth.topology.corner_count, depth);
}

void restrict_to_coarse(Stream& stream, const Depth& fine, const Depth& coarse) {
  launch(stream, restrict_kernel, coarse.topology.corner_count, fine, coarse);
}

void add_prolonged(Stream& stream, const Depth& coarse, const Depth& fine) {
  launch(stream, prolong_kernel, fine.topology.corner_count, coarse, fine);
}

}  // namespace burnish::cuda
