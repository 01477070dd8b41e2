#pragma once

// The common part of the .cu files: vectors of three columns, rows, and the start of kernels.

#include <algorithm>

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

inline constexpr int kThreads = 128;

/// Starts blocks of threads with this much shared memory beyond what they declare. If the device
/// can, blocks start while the previous kernel still runs, and wait in await_previous(). Otherwise
/// the starts of kernels would take much of a small depth's time.
template <typename... Params, typename... Args>
void launch_blocks(Stream& stream, void (*kernel)(Params...), dim3 blocks, dim3 threads,
                   size_t shared_bytes, Args... args) {
  if (!stream.is_ok() || blocks.x == 0) return;
  cudaLaunchAttribute attributes[2] = {};
  cudaLaunchConfig_t config = {};
  config.gridDim = blocks;
  config.blockDim = threads;
  config.dynamicSmemBytes = shared_bytes;
  config.stream = stream.get();
  config.attrs = attributes;
  if (stream.starts_early()) {
    cudaLaunchAttribute& early = attributes[config.numAttrs++];
    early.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    early.val.programmaticStreamSerializationAllowed = 1;
  }
  if (stream.shared_percent() != Stream::kAsItSuits) {
    cudaLaunchAttribute& split = attributes[config.numAttrs++];
    split.id = cudaLaunchAttributePreferredSharedMemoryCarveout;
    split.val.sharedMemCarveout = static_cast<unsigned>(stream.shared_percent());
  }
  stream.check(cudaLaunchKernelEx(&config, kernel, static_cast<Params>(args)...),
               "starting a kernel");
}

/// Returns how many blocks give a thread to each of `count` items.
inline unsigned block_count(int64_t count) {
  return static_cast<unsigned>((count + kThreads - 1) / kThreads);
}

/// Starts one thread for each of `count` items.
template <typename... Params, typename... Args>
void launch(Stream& stream, void (*kernel)(Params...), int64_t count, Args... args) {
  if (count > 0)
    launch_blocks(stream, kernel, dim3(block_count(count)), dim3(kThreads), 0, args...);
}

/// Starts one thread for each of `count` items once all earlier work of the stream has ended, which
/// may be that of other devices. The kernel need not wait.
template <typename... Params, typename... Args>
void launch_whole(Stream& stream, void (*kernel)(Params...), int64_t count, Args... args) {
  if (!stream.is_ok() || count == 0) return;
  cudaLaunchConfig_t config = {};
  config.gridDim = dim3(block_count(count));
  config.blockDim = dim3(kThreads);
  config.stream = stream.get();
  stream.check(cudaLaunchKernelEx(&config, kernel, static_cast<Params>(args)...),
               "starting a kernel");
}

/// Lets the next kernel start. The first statement of a kernel that has work before
/// await_previous().
__device__ inline void let_next_start() {
#if __CUDA_ARCH__ >= 900
  cudaTriggerProgrammaticLaunchCompletion();
#endif
}

/// Waits for the writes of the previous kernels. Before this call a kernel may read only data that
/// no kernel wrote since a host's wait, another graph, a copy or a memset: the mesh, and within a
/// cycle the matrices.
__device__ inline void await_previous() {
  let_next_start();
#if __CUDA_ARCH__ >= 900
  cudaGridDependencySynchronize();
#endif
}

/// Does the same, but the next kernel starts only then. So at most two kernels of a long chain are
/// on the device; more waiting ones would keep other work from it.
__device__ inline void await_previous_alone() {
#if __CUDA_ARCH__ >= 900
  cudaGridDependencySynchronize();
#endif
  let_next_start();
}

__device__ inline int64_t thread_index() {
  return static_cast<int64_t>(blockIdx.x) * blockDim.x + threadIdx.x;
}

/// Limits the blocks of threads that go through a list of blocks: enough to fill a device.
inline constexpr int kListingBlocksMax = 1056;

/// Returns how many blocks of threads do all of `blocks`, or those of a list.
inline dim3 blocks_for(int64_t blocks, const BlockList& list) {
  if (list.lists == nullptr) return dim3(static_cast<unsigned>(blocks));
  return dim3(static_cast<unsigned>(std::min<int64_t>(blocks, kListingBlocksMax)));
}

/// Calls work(block) for this block of threads alone, or for its part of a listed kernel's list.
/// Every thread calls it. A listed kernel waits for the previous ones even if its list is empty:
/// the next kernel relies on it.
template <bool kListed, typename Work>
__device__ __forceinline__ void for_own_blocks(const BlockList& list, Work&& work) {
  if constexpr (!kListed) {
    work(static_cast<int32_t>(blockIdx.x));
  } else {
    await_previous();
    const int32_t end = list.lists[list.number + 1];
    for (auto i = list.lists[list.number] + static_cast<int32_t>(blockIdx.x); i < end;
         i += static_cast<int32_t>(gridDim.x)) {
      work(list.lists[i]);
      __syncthreads();  // the block's shared memory is free again
    }
  }
}

/// Returns whether a block is listed; without a list all are.
__device__ inline bool is_listed(const BlockList& list, int32_t block) {
  if (list.lists == nullptr) return true;
  int32_t first = list.lists[list.number], end = list.lists[list.number + 1];
  while (first < end) {
    const int32_t middle = (first + end) / 2;
    if (list.lists[middle] == block) return true;
    if (list.lists[middle] < block)
      first = middle + 1;
    else
      end = middle;
  }
  return false;
}

__device__ inline float4 operator+(float4 a, float4 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, 0};
}
__device__ inline float4 operator-(float4 a, float4 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z, 0};
}
__device__ inline float4 operator*(float s, float4 a) {
  return {s * a.x, s * a.y, s * a.z, 0};
}
__device__ inline float4 zero4() {
  return {0, 0, 0, 0};
}

__device__ inline Double3 operator+(Double3 a, Double3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
__device__ inline Double3 operator-(Double3 a, Double3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
__device__ inline Double3 operator*(double s, Double3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
__device__ inline Double3 operator*(Double3 a, Double3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
__device__ inline Double3 to_double(float4 a) {
  return {a.x, a.y, a.z};
}
__device__ inline float4 to_float(Double3 a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z), 0};
}
__device__ inline double sum_of(Double3 a) {
  return a.x + a.y + a.z;
}

template <typename Real>
__device__ Real& pair_of(const CellSquares<Real>& squares, int64_t cell, int pair) {
  return squares.numbers[pair * squares.cells + cell];
}
template <typename Real>
__device__ Real& own_of(const CellSquares<Real>& squares, int64_t cell, int corner) {
  return squares.numbers[(kPairsPerCell + corner) * squares.cells + cell];
}

__device__ inline int64_t row_begin(const Rows& rows, int32_t i) {
  return rows.slice_start[i / kSliceRows] + i % kSliceRows;
}
__device__ inline int64_t row_end(const Rows& rows, int32_t i, int64_t begin) {
  return begin + kSliceRows * __popc(rows.mask[i]);
}
/// Returns where slot s of row i stands. Needs: the row has the slot.
__device__ inline int64_t entry_position(const Rows& rows, int32_t i, int slot) {
  return row_begin(rows, i) + kSliceRows * __popc(rows.mask[i] & ((1u << slot) - 1));
}

}  // namespace burnish::cuda
