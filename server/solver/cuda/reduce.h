#pragma once

#include <algorithm>

#include "server/solver/cuda/kernel.h"

// Sums in an order that the count alone fixes: a bounded number of blocks stride over the items,
// then one block adds what they found.

namespace burnish::cuda {

/// How many blocks, and so how many partial sums, a sum over `count` items takes.
inline int partial_count(int64_t count) {
  return static_cast<int>(std::min<int64_t>(kPartialsMax, (count + kThreads - 1) / kThreads));
}

/// Starts a kernel whose threads stride over `count` items.
template <typename... Params, typename... Args>
void launch_striding(Stream& stream, void (*kernel)(Params...), int64_t count, Args... args) {
  launch(stream, kernel, static_cast<int64_t>(partial_count(count)) * kThreads, args...);
}
template <typename... Params, typename... Args>
void launch_one_block(Stream& stream, void (*kernel)(Params...), Args... args) {
  launch(stream, kernel, kThreads, args...);
}
__device__ inline int64_t stride() {
  return static_cast<int64_t>(gridDim.x) * blockDim.x;
}

/// The block's sum, in its first thread. Every thread of the block calls it, once in a kernel.
template <int kCount>
__device__ Sums<kCount> block_sum(Sums<kCount> sum) {
  __shared__ Sums<kCount> of_warp[kThreads / 32];
  for (int offset = 16; offset > 0; offset /= 2)
    for (double& number : sum.at) number += __shfl_down_sync(0xffffffffu, number, offset);
  if (threadIdx.x % 32 == 0) of_warp[threadIdx.x / 32] = sum;
  __syncthreads();
  if (threadIdx.x == 0)
    for (int warp = 1; warp < kThreads / 32; ++warp)
      for (int n = 0; n < kCount; ++n) sum.at[n] += of_warp[warp].at[n];
  return sum;
}

/// The sum of all partial sums, in the first thread of a single block.
template <int kCount>
__device__ Sums<kCount> total_of(const Sums<kCount>* partials, int count) {
  Sums<kCount> sum = {};
  for (int i = static_cast<int>(threadIdx.x); i < count; i += kThreads)
    for (int n = 0; n < kCount; ++n) sum.at[n] += partials[i].at[n];
  return block_sum(sum);
}

}  // namespace burnish::cuda
