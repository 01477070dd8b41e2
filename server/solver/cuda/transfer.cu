#include "server/solver/cuda/half_way.h"
#include "server/solver/cuda/long_products.h"
#include "server/solver/cuda/transfer.h"

namespace burnish::cuda {

namespace {

constexpr int kLanes = 4;  // threads for one coarse corner
constexpr int kGatheredMax = (kRestrictionMax + kLanes - 1) / kLanes;

template <bool kLong>
__global__ void __launch_bounds__(kThreads, kLong ? 6 : 8) residual_kernel(Depth depth) {
  float4* tile = tile_of_block<float4>();
  let_next_start();
  const FetchedRow row = fetch_row(depth.topology.rows, depth.system.packed, blockIdx.x);
  LongPart<kLong> beyond(depth.topology.rows.long_rows, depth.system.long_entries, row);
  const int32_t i = row.corner;
  const bool is_free = i >= 0 && depth.inverse_diagonal[i] != 0;
  const float diagonal = is_free ? depth.system.diagonal[i] : 0;
  await_previous();
  const float4 f = is_free ? depth.f[i] : zero4();
  beyond.start(depth.x);
  fill_tile(row, depth.x, tile);
  beyond.finish(depth.x);
  if (i < 0) return;
  const float4 product = beyond.added_to(product_of(row, tile));
  depth.r[i] = is_free ? f - diagonal * tile[threadIdx.x] - product : zero4();
}

// What a corner takes from those of another depth by the list from `begin` to `end`, every `step`
// th.
__device__ float4 weighted_sum(const WeightedCorners& list, int32_t begin, int32_t end, int step,
                               const float4* vector) {
  float4 sum = zero4();
#pragma unroll 4
  for (int32_t k = begin; k < end; k += step) sum = sum + list.weight[k] * vector[list.corner[k]];
  return sum;
}

// kRest: of some corners there is more than what is packed.
template <bool kRest>
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
  const WeightedCorners& rest = fine.topology.restriction_rest;
  const int32_t rest_begin = kRest ? rest.start[i] + lane : 0,
                rest_end = kRest ? rest.start[i + 1] : 0;
  const bool is_free = coarse.inverse_diagonal[i] > 0;
  await_previous();
  float4 sum = zero4();
#pragma unroll
  for (int j = 0; j < kGatheredMax; ++j) sum = sum + weight[j] * fine.r[from[j]];
  if (kRest) sum = sum + weighted_sum(rest, rest_begin, rest_end, kLanes, fine.r);
  const unsigned group = ((1u << kLanes) - 1) << (threadIdx.x % 32 / kLanes * kLanes);
#pragma unroll
  for (int offset = kLanes / 2; offset > 0; offset /= 2) {
    sum.x += __shfl_xor_sync(group, sum.x, offset);
    sum.y += __shfl_xor_sync(group, sum.y, offset);
    sum.z += __shfl_xor_sync(group, sum.z, offset);
  }
  if (lane == 0) coarse.f[i] = is_free ? sum : zero4();
}

// kShared: some corners take from those of several cells.
template <bool kShared>
__global__ void prolong_kernel(Depth coarse, Depth fine) {
  let_next_start();
  const int64_t i = thread_index();
  if (i >= fine.topology.corner_count || fine.inverse_diagonal[i] == 0) return;
  const FromCell from = fine.topology.prolongation[i];
  if (kShared && from.cell < 0) {
    const WeightedCorners& shared = fine.topology.shared;
    const int32_t begin = shared.start[-1 - from.cell], end = shared.start[-from.cell];
    await_previous();
    fine.x[i] = fine.x[i] + weighted_sum(shared, begin, end, 1, coarse.x);
    return;
  }
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
  launch_products<float4>(stream, has_long(rows) ? residual_kernel<true> : residual_kernel<false>,
                          rows, rows.group_count, depth);
}

void restrict_to_coarse(Stream& stream, const Depth& fine, const Depth& coarse) {
  const bool has_rest = fine.topology.restriction_rest.start != nullptr;
  launch(stream, has_rest ? restrict_kernel<true> : restrict_kernel<false>,
         kLanes * int64_t{coarse.topology.corner_count}, fine, coarse);
}

void add_prolonged(Stream& stream, const Depth& coarse, const Depth& fine) {
  const bool has_shared = fine.topology.shared.start != nullptr;
  launch(stream, has_shared ? prolong_kernel<true> : prolong_kernel<false>,
         fine.topology.corner_count, coarse, fine);
}

}  // namespace burnish::cuda
