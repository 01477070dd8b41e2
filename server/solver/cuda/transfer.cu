#include "server/solver/cuda/products.h"
#include "server/solver/cuda/transfer.h"

namespace burnish::cuda {

namespace {

constexpr int kLanes = 4;  // threads for one coarse corner, which gathers 27 fine ones at the most
constexpr int kGatheredMax = (27 + kLanes - 1) / kLanes;

__global__ void __launch_bounds__(kThreads, 8) residual_kernel(Depth depth) {
  float4* tile = tile_of_block<float4>();
  let_next_start();
  const FetchedRow row = fetch_row(depth.topology.rows, depth.system.packed, blockIdx.x);
  const int32_t i = row.corner;
  const bool is_free = i >= 0 && depth.inverse_diagonal[i] != 0;
  const float diagonal = is_free ? depth.system.diagonal[i] : 0;
  await_previous();
  const float4 f = is_free ? depth.f[i] : zero4();
  fill_tile(row, depth.x, tile);
  if (i < 0) return;
  depth.r[i] = is_free ? f - diagonal * tile[threadIdx.x] - product_of(row, tile) : zero4();
}

__global__ void restrict_kernel(Depth fine, Depth coarse) {
  let_next_start();
  const int64_t i = thread_index() / kLanes;
  if (i >= coarse.topology.corner_count) return;
  const auto lane = static_cast<int>(threadIdx.x % kLanes);
  const int64_t begin = fine.topology.restriction_start[i];
  const auto count = static_cast<int>(fine.topology.restriction_start[i + 1] - begin);
  int32_t from[kGatheredMax];
  float weight[kGatheredMax];
#pragma unroll
  for (int j = 0; j < kGatheredMax; ++j) {
    const int k = lane + kLanes * j;
    const uint32_t restriction = k < count ? fine.topology.restriction[begin + k] : 0;
    from[j] = corner_of(restriction);
    weight[j] = k < count ? weight_of(restriction) : 0;
  }
  const bool is_free = coarse.inverse_diagonal[i] > 0;
  await_previous();
  float4 sum = zero4();
#pragma unroll
  for (int j = 0; j < kGatheredMax; ++j) sum = sum + weight[j] * fine.r[from[j]];
  const unsigned group = ((1u << kLanes) - 1) << (threadIdx.x % 32 / kLanes * kLanes);
#pragma unroll
  for (int offset = kLanes / 2; offset > 0; offset /= 2) {
    sum.x += __shfl_xor_sync(group, sum.x, offset);
    sum.y += __shfl_xor_sync(group, sum.y, offset);
    sum.z += __shfl_xor_sync(group, sum.z, offset);
  }
  if (lane == 0) coarse.f[i] = is_free ? sum : zero4();
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
  let_next_start();
  const int64_t i = thread_index();
  if (i >= fine.topology.corner_count || fine.inverse_diagonal[i] == 0) return;
  const FromCell from = fine.topology.prolongation[i];
  const Eight corners = coarse.topology.cell_corners[from.cell];
  await_previous();
  float4 sum = fine.x[i];
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const float weight = half_way_weight(from.place, a);
    sum = sum + weight * coarse.x[weight > 0 ? corners.at[a] : corners.at[0]];
  }
  fine.x[i] = sum;
}

}  // namespace

void compute_residual(Stream& stream, const Depth& depth) {
  const Rows& rows = depth.topology.rows;
  launch_products<float4>(stream, residual_kernel, rows, rows.group_count, depth);
}

void restrict_to_coarse(Stream& stream, const Depth& fine, const Depth& coarse) {
  launch(stream, restrict_kernel, kLanes * int64_t{coarse.topology.corner_count}, fine, coarse);
}

void add_prolonged(Stream& stream, const Depth& coarse, const Depth& fine) {
  launch(stream, prolong_kernel, fine.topology.corner_count, coarse, fine);
}

}  // namespace burnish::cuda
