#pragma once

// What the .cu files share: vectors of three columns, rows, and how a kernel is started. Products
// of rows are unrolled so that several of their loads are under way at once.

#include "server/solver/cuda/stream.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

inline constexpr int kThreads = 128;

/// Starts one thread for each of `count` items. Where the device can, the kernel's blocks come up
/// while the one before still runs, and wait in await_previous(): much of a small depth's time
/// would else be the starting of kernels.
template <typename... Params, typename... Args>
void launch(Stream& stream, void (*kernel)(Params...), int64_t count, Args... args) {
  if (count == 0 || !stream.is_ok()) return;
  cudaLaunchAttribute early = {};
  early.id = cudaLaunchAttributeProgrammaticStreamSerialization;
  early.val.programmaticStreamSerializationAllowed = 1;
  cudaLaunchConfig_t config = {};
  config.gridDim = dim3(static_cast<unsigned>((count + kThreads - 1) / kThreads));
  config.blockDim = dim3(kThreads);
  config.stream = stream.get();
  config.attrs = &early;
  config.numAttrs = stream.starts_early() ? 1 : 0;
  stream.check(cudaLaunchKernelEx(&config, kernel, static_cast<Params>(args)...),
               "starting a kernel");
}

/// The first statement of every kernel: what the kernel before has written is there afterwards.
__device__ inline void await_previous() {
#if __CUDA_ARCH__ >= 900
  cudaTriggerProgrammaticLaunchCompletion();
  cudaGridDependencySynchronize();
#endif
}

__device__ inline int64_t thread_index() {
  return static_cast<int64_t>(blockIdx.x) * blockDim.x + threadIdx.x;
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
  return {a.x + b.x, a.y + b.y, a.z + b.z, 0};
}
__device__ inline Double3 operator-(Double3 a, Double3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z, 0};
}
__device__ inline Double3 operator*(double s, Double3 a) {
  return {s * a.x, s * a.y, s * a.z, 0};
}
__device__ inline Double3 operator*(Double3 a, Double3 b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z, 0};
}
__device__ inline Double3 to_double(float4 a) {
  return {a.x, a.y, a.z, 0};
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
  return squares.numbers[(28 + corner) * squares.cells + cell];
}

__device__ inline int64_t row_begin(const Rows& rows, int32_t i) {
  return rows.slice_start[i / kSliceRows] + i % kSliceRows;
}
__device__ inline int64_t row_end(const Rows& rows, int32_t i, int64_t begin) {
  return begin + kSliceRows * __popc(rows.mask[i]);
}
/// Where slot s of row i stands. Needs: the slot is present.
__device__ inline int64_t entry_position(const Rows& rows, int32_t i, int slot) {
  return row_begin(rows, i) + kSliceRows * __popc(rows.mask[i] & ((1u << slot) - 1));
}

// A row in chunks of which all loads are under way at once; rows of the surface's inside have 17 or
// 26 neighbours. Places beyond the row's end stand for the row's own corner, with weight zero.
inline constexpr int kChunk = 9;

/// (A x)_i.
__device__ inline float4 product_row(const Rows& rows, const Matrix& matrix, const float4* x,
                                     int32_t i) {
  float4 sum = matrix.diagonal[i] * x[i];
  const int64_t begin = row_begin(rows, i);
  const int count = __popc(rows.mask[i]);
  for (int first = 0; first < count; first += kChunk) {
    int32_t column[kChunk];
    float entry[kChunk];
#pragma unroll
    for (int j = 0; j < kChunk; ++j) {
      const bool present = first + j < count;
      const int64_t k = begin + kSliceRows * (first + j);
      column[j] = present ? rows.column[k] : i;
      entry[j] = present ? matrix.entry[k] : 0;
    }
#pragma unroll
    for (int j = 0; j < kChunk; ++j) sum = sum + entry[j] * x[column[j]];
  }
  return sum;
}

/// (S x)_i as Σ_j S_ij (x_j − x_i) + m_i x_i, which loses nothing for smooth x.
__device__ inline Double3 product_row(const Rows& rows, const ExactMatrix& matrix, const Double3* x,
                                      int32_t i) {
  const Double3 here = x[i];
  Double3 sum = matrix.row_sum[i] * here;
  const int64_t begin = row_begin(rows, i), end = row_end(rows, i, begin);
#pragma unroll 4
  for (int64_t k = begin; k < end; k += kSliceRows)
    sum = sum + matrix.entry[k] * (x[rows.column[k]] - here);
  return sum;
}

}  // namespace burnish::cuda
