#include "server/solver/cuda/assembly/half_way.h"
#include "server/solver/cuda/products/long_products.h"
#include "server/solver/cuda/products/transfer.h"

namespace burnish::cuda {

namespace {

constexpr int kLanes = 4;  // threads per coarse corner
constexpr int kGatheredMax = (kRestrictionMax + kLanes - 1) / kLanes;

template <bool kLong, bool kExactInSomeGroups>
__global__ void __launch_bounds__(kThreads, kLong ? 6 : 8) residual_kernel(Depth depth) {
  float4* tile = tile_of_block<float4>();
  let_next_start();
  const FetchedRow row = fetch_row(depth.topology.rows, depth.system.packed, blockIdx.x);
  LongPart<kLong> beyond(depth.topology.rows.long_rows, depth.system.long_entries, row);
  const bool is_exact = kExactInSomeGroups && depth.topology.is_exact[blockIdx.x] != 0;
  const int32_t i = row.corner;
  const bool is_free = i >= 0 && depth.inverse_diagonal[i] != 0;
  const float diagonal = is_free ? depth.system.diagonal[i] : 0;
  await_previous();
  const float4 f = is_free ? depth.f[i] : zero4();
  beyond.start(depth.x);
  fill_tile(row, depth.x, tile);
  beyond.finish(depth.x);
  if (i < 0) return;
  float4 product = beyond.added_to(product_of(row, tile));
  if (is_exact) product = product + rest_of_product(depth.system.rest, row, tile);
  depth.r[i] = is_free ? f - diagonal * tile[threadIdx.x] - product : zero4();
}

// Returns the sum over kCount neighbouring threads, in each of them.
template <int kCount>
__device__ float4 sum_of_lanes(float4 sum) {
  const unsigned group = ((1u << kCount) - 1) << (threadIdx.x % 32 / kCount * kCount);
#pragma unroll
  for (int offset = kCount / 2; offset > 0; offset /= 2) {
    sum.x += __shfl_xor_sync(group, sum.x, offset);
    sum.y += __shfl_xor_sync(group, sum.y, offset);
    sum.z += __shfl_xor_sync(group, sum.z, offset);
  }
  return sum;
}

// Corners with a list have their own blocks, the first ones of a kernel: they take longest.
struct ListedBlocks {
  unsigned count;

  __device__ bool has_block() const { return blockIdx.x < count; }
  // Index among the other threads.
  __device__ int64_t other_thread() const { return thread_index() - int64_t{count} * kThreads; }
};

constexpr int kListedLanes = 8;  // threads per listed corner
constexpr int kListedAhead = 4;  // numbers per thread

// The weighted sum of a listed corner, shared among the threads of a group. Finds the first places,
// as many as registers keep, at once; this may come before await_previous().
class WeightedSum {
 public:
  __device__ WeightedSum(const ListedCorners& list, int64_t number)
      : list_(list),
        next_(list.start[number] + static_cast<int>(threadIdx.x % kListedLanes)),
        end_(list.start[number + 1]) {
#pragma unroll
    for (int j = 0; j < kListedAhead; ++j, next_ += kListedLanes) {
      from_[j] = next_ < end_ ? list_.from[next_] : -1;
      weight_[j] = next_ < end_ ? list_.weight[next_] : 0;
    }
  }

  // Returns the group's sum in each of its threads. All of them call it.
  __device__ float4 of(const float4* vector) const {
    float4 sum = zero4();
#pragma unroll
    for (int j = 0; j < kListedAhead; ++j)
      if (from_[j] >= 0) sum = sum + weight_[j] * vector[from_[j]];
    for (int32_t k = next_; k < end_; k += kListedLanes)
      sum = sum + list_.weight[k] * vector[list_.from[k]];
    return sum_of_lanes<kListedLanes>(sum);
  }

 private:
  const ListedCorners& list_;
  int32_t next_, end_;
  int32_t from_[kListedAhead];
  float weight_[kListedAhead];
};

__device__ void restrict_listed(const Depth& fine, const Depth& coarse, int64_t thread) {
  const int64_t number = thread / kListedLanes;
  if (number >= fine.topology.listed.count) return;
  const int32_t i = fine.topology.listed.corner[number];
  const WeightedSum weighted(fine.topology.listed, number);
  const bool is_free = coarse.inverse_diagonal[i] > 0;
  await_previous();
  const float4 sum = weighted.of(fine.r);
  if (thread % kListedLanes == 0) coarse.f[i] = is_free ? sum : zero4();
}

template <bool kListed>
__device__ void restrict_packed(const Depth& fine, const Depth& coarse, int64_t thread) {
  const int64_t i = thread / kLanes;
  if (i >= coarse.topology.corner_count) return;
  const auto lane = static_cast<int>(threadIdx.x % kLanes);
  const int64_t begin = fine.topology.restriction_start[i];
  const auto count = static_cast<int>(fine.topology.restriction_start[i + 1] - begin);
  if (kListed && count == 0) return;
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
  sum = sum_of_lanes<kLanes>(sum);
  if (lane == 0) coarse.f[i] = is_free ? sum : zero4();
}

template <bool kListed>
__global__ void restrict_kernel(Depth fine, Depth coarse, ListedBlocks listed) {
  let_next_start();
  if (kListed && listed.has_block())
    restrict_listed(fine, coarse, thread_index());
  else
    restrict_packed<kListed>(fine, coarse, kListed ? listed.other_thread() : thread_index());
}

__device__ void prolong_to_shared(const Depth& coarse, const Depth& fine, int64_t thread) {
  const int64_t number = thread / kListedLanes;
  if (number >= fine.topology.shared.count) return;
  const int32_t i = fine.topology.shared.corner[number];
  const WeightedSum weighted(fine.topology.shared, number);
  if (fine.inverse_diagonal[i] == 0) return;
  await_previous();
  const bool is_first = thread % kListedLanes == 0;
  const float4 x = is_first ? fine.x[i] : zero4();
  const float4 sum = x + weighted.of(coarse.x);
  if (is_first) fine.x[i] = sum;
}

__device__ bool is_shared(const FromCell& from) {
  return from.cell < 0;
}

template <bool kShared>
__device__ void prolong_from_cell(const Depth& coarse, const Depth& fine, int64_t i) {
  if (i >= fine.topology.own_count || fine.inverse_diagonal[i] == 0) return;
  const FromCell from = fine.topology.prolongation[i];
  if (kShared && is_shared(from)) return;
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

template <bool kShared>
__global__ void prolong_kernel(Depth coarse, Depth fine, ListedBlocks shared) {
  let_next_start();
  if (kShared && shared.has_block())
    prolong_to_shared(coarse, fine, thread_index());
  else
    prolong_from_cell<kShared>(coarse, fine, kShared ? shared.other_thread() : thread_index());
}

// Starts one of two kernels with a thread for each of `count` items. The first kernel also has
// blocks for listed corners.
template <typename Kernel>
void launch_with_listed(Stream& stream, Kernel* with_listed, Kernel* without, int64_t count,
                        const ListedCorners& list, const Depth& from, const Depth& to) {
  const ListedBlocks listed = {block_count(int64_t{kListedLanes} * list.count)};
  const unsigned blocks = listed.count + block_count(count);
  launch_blocks(stream, list.count > 0 ? with_listed : without, dim3(blocks), dim3(kThreads), 0,
                from, to, listed);
}

}  // namespace

void compute_residual(Stream& stream, const Depth& depth) {
  const Rows& rows = depth.topology.rows;
  const bool is_exact = depth.topology.is_exact != nullptr;
  const auto kernel =
      has_long(rows) ? (is_exact ? residual_kernel<true, true> : residual_kernel<true, false>)
                     : (is_exact ? residual_kernel<false, true> : residual_kernel<false, false>);
  launch_products<float4>(stream, kernel, rows, rows.own_group_count, depth);
}

void restrict_to_coarse(Stream& stream, const Depth& fine, const Depth& coarse) {
  launch_with_listed(stream, restrict_kernel<true>, restrict_kernel<false>,
                     kLanes * int64_t{coarse.topology.corner_count}, fine.topology.listed, fine,
                     coarse);
}

void restrict_from_zero(Stream& stream, const Depth& fine, const Depth& coarse) {
  if (stream.is_ok())
    stream.check(
        cudaMemsetAsync(fine.x, 0, fine.topology.corner_count * sizeof(float4), stream.get()),
        "clearing a correction");
  Depth with_residual = fine;
  with_residual.r = fine.f;
  restrict_to_coarse(stream, with_residual, coarse);
}

void add_prolonged(Stream& stream, const Depth& coarse, const Depth& fine) {
  launch_with_listed(stream, prolong_kernel<true>, prolong_kernel<false>, fine.topology.own_count,
                     fine.topology.shared, coarse, fine);
}

}  // namespace burnish::cuda
