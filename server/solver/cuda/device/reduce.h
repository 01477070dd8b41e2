#pragma once

#include <algorithm>

#include "server/solver/cuda/device/kernel.h"

// Sums in an order that depends on the count only: a bounded number of blocks stride over the
// items, and the last block to end adds all partial sums.

namespace burnish::cuda {

/// Returns how many blocks, and so how many partial sums, a sum over `count` items takes.
inline int partial_count(int64_t count) {
  return static_cast<int>(std::min<int64_t>(kPartialsMax, (count + kThreads - 1) / kThreads));
}

/// Starts a kernel whose threads stride over `count` items.
template <typename... Params, typename... Args>
void launch_striding(Stream& stream, void (*kernel)(Params...), int64_t count, Args... args) {
  launch(stream, kernel, static_cast<int64_t>(partial_count(count)) * kThreads, args...);
}
__device__ inline int64_t stride() {
  return static_cast<int64_t>(gridDim.x) * blockDim.x;
}

/// Returns the block's sum in its first thread. Every thread of the block calls it.
template <int kCount>
__device__ Sums<kCount> block_sum(Sums<kCount> sum) {
  __shared__ Sums<kCount> of_warp[kThreads / 32];
  __syncthreads();
  for (int offset = 16; offset > 0; offset /= 2)
    for (double& number : sum.at) number += __shfl_down_sync(0xffffffffu, number, offset);
  if (threadIdx.x % 32 == 0) of_warp[threadIdx.x / 32] = sum;
  __syncthreads();
  if (threadIdx.x == 0)
    for (int warp = 1; warp < kThreads / 32; ++warp)
      for (int n = 0; n < kCount; ++n) sum.at[n] += of_warp[warp].at[n];
  return sum;
}

/// Every block of the kernel calls it with its sum, with all its threads. Returns true in the first
/// thread of the last block, which then has the total.
template <int kCount>
__device__ bool add_up(Sums<kCount> sum, const Partials<kCount>& partials, Sums<kCount>* total) {
  __shared__ bool is_last;
  sum = block_sum(sum);
  if (threadIdx.x == 0) {
    partials.sums[blockIdx.x] = sum;
    __threadfence();
    is_last = atomicInc(partials.arrived, gridDim.x - 1) == gridDim.x - 1;  // back to zero
  }
  __syncthreads();
  if (!is_last) return false;
  __threadfence();
  sum = {};
  for (unsigned i = threadIdx.x; i < gridDim.x; i += kThreads)
    for (int n = 0; n < kCount; ++n) sum.at[n] += __ldcg(&partials.sums[i].at[n]);
  *total = block_sum(sum);
  return threadIdx.x == 0;
}

/// Writes totals for the other shards.
template <int kCount>
__device__ void tell(const Sums<kCount>& total, double* totals) {
  static_assert(kCount <= OfShards::kTotals);
  for (int n = 0; n < kCount; ++n) totals[n] = total.at[n];
}

/// Returns the sums over all shards.
template <int kCount>
__device__ Sums<kCount> sum_of(const OfShards& shards) {
  Sums<kCount> sum = {};
  for (int shard = 0; shard < shards.count; ++shard)
    for (int n = 0; n < kCount; ++n) sum.at[n] += shards.totals[shard][n];
  return sum;
}

}  // namespace burnish::cuda
