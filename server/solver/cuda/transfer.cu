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

// What a corner takes from those of another depth by a list, every `step` th of it. The first
// kAhead are found at once, which may come before await_previous().
template <int kAhead>
class ListedCorners {
 public:
  __device__ ListedCorners(const WeightedCorners& list, int32_t begin, int32_t end, int step)
      : list_(list), next_(begin), end_(end), step_(step) {
#pragma unroll
    for (int j = 0; j < kAhead; ++j, next_ += step_) {
      corner_[j] = next_ < end_ ? list_.corner[next_] : 0;
      weight_[j] = next_ < end_ ? list_.weight[next_] : 0;
    }
  }

  __device__ float4 sum_of(const float4* vector) const {
    float4 sum = zero4();
#pragma unroll
    for (int j = 0; j < kAhead; ++j) sum = sum + weight_[j] * vector[corner_[j]];
#pragma unroll 4
    for (int32_t k = next_; k < end_; k += step_)
      sum = sum + list_.weight[k] * vector[list_.corner[k]];
    return sum;
  }

 private:
  const WeightedCorners& list_;
  int32_t next_, end_;
  int step_;
  int32_t corner_[kAhead];
  float weight_[kAhead];
};

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
  const ListedCorners<2> more(rest, kRest ? rest.start[i] + lane : 0, kRest ? rest.start[i + 1] : 0,
                              kLanes);
  const bool is_free = coarse.inverse_diagonal[i] > 0;
  await_previous();
  float4 sum = zero4();
#pragma unroll
  for (int j = 0; j < kGatheredMax; ++j) sum = sum + weight[j] * fine.r[from[j]];
  if (kRest) sum = sum + more.sum_of(fine.r);
  const unsigned group = ((1u << kLanes) - 1) << (threadIdx.x % 32 / kLanes * kLanes);
#pragma unroll
  for (int offset = kLanes / 2; offset > 0; offset /= 2) {
    sum.x += __shfl_xor_sync(group, sum.x, offset);
    sum.y += __shfl_xor_sync(group, sum.y, offset);
    sum.z += __shfl_xor_sync(group, sum.z, offset);
  }
  if (lane == 0) coarse.f[i] = is_free ? sum : zero4();
}

// Shared corners are left out.
template <bool kShared>
__device__ void prolong_from_cell(const Depth& coarse, const Depth& fine, int64_t i) {
  if (i >= fine.topology.corner_count || fine.inverse_diagonal[i] == 0) return;
  const FromCell from = fine.topology.prolongation[i];
  if (kShared && from.cell < 0) return;
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

__device__ void prolong_to_shared(const Depth& coarse, const Depth& fine, int64_t number) {
  const SharedCorners& shared = fine.topology.shared;
  if (number >= shared.count) return;
  const int32_t i = shared.corner[number];
  const ListedCorners<4> listed(shared.from, shared.from.start[number],
                                shared.from.start[number + 1], 1);
  if (fine.inverse_diagonal[i] == 0) return;
  await_previous();
  fine.x[i] = fine.x[i] + listed.sum_of(coarse.x);
}

// kShared: the last blocks do shared corners.
template <bool kShared>
__global__ void prolong_kernel(Depth coarse, Depth fine, unsigned corner_blocks) {
  let_next_start();
  if (kShared && blockIdx.x >= corner_blocks)
    prolong_to_shared(coarse, fine, thread_index() - int64_t{corner_blocks} * kThreads);
  else
    prolong_from_cell<kShared>(coarse, fine, thread_index());
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
  const unsigned corner_blocks = block_count(fine.topology.corner_count);
  const int32_t shared = fine.topology.shared.count;
  launch_blocks(stream, shared > 0 ? prolong_kernel<true> : prolong_kernel<false>,
                dim3(corner_blocks + block_count(shared)), dim3(kThreads), 0, coarse, fine,
                corner_blocks);
}

}  // namespace burnish::cuda
