#pragma once

#include "server/solver/cuda/kernel.h"
#include "server/solver/cuda/packed.h"
#include "server/solver/stencil_slots.h"

// Products of a matrix with a vector: a block of threads for each group of rows, a thread for each
// row. Whatever a cycle leaves as it is, a thread fetches before it waits for the kernel before;
// after that a small depth's product is hardly more than one read of the vector.

namespace burnish::cuda {

inline constexpr int kEntriesMax = kSlots - 1;
inline constexpr int kEntriesUsual = 18;  // rows of the surface's inside have 17 or 26
inline constexpr int kHaloAhead = 2;      // of a thread; as much as most groups have

/// The rows that a block does.
struct Group {
  int32_t first, count;
  const int32_t* halo;
  int32_t halo_count;
};

__device__ inline Group group_of(const Rows& rows, int32_t g) {
  const int32_t first = g * rows.group_rows, halo = rows.halo_start[g];
  return {first, min(rows.group_rows, rows.count - first), rows.halo + halo,
          rows.halo_start[g + 1] - halo};
}

/// The corner of a column by its place in the group's tile.
__device__ inline int32_t column_of(const Group& group, uint32_t local) {
  const auto at = static_cast<int32_t>(local);
  return at < group.count ? group.first + at : group.halo[at - group.count];
}

/// The corner whose row this thread does, or -1.
__device__ inline int32_t row_of(const Group& group) {
  const auto t = static_cast<int32_t>(threadIdx.x);
  return t < group.count ? group.first + t : -1;
}

/// A thread's row, and its part of the halo.
struct FetchedRow {
  Group group;
  int32_t corner;  // -1 for none
  int count;       // of its entries
  int64_t begin;   // of its entries
  uint32_t packed[kEntriesMax];
  int32_t halo[kHaloAhead];
};

__device__ inline FetchedRow fetch_row(const Rows& rows, const uint32_t* packed, int32_t g) {
  FetchedRow row;
  row.group = group_of(rows, g);
  row.corner = row_of(row.group);
  row.count = row.corner >= 0 ? __popc(rows.mask[row.corner]) : 0;
  row.begin = row.corner >= 0 ? row_begin(rows, row.corner) : 0;
#pragma unroll
  for (int j = 0; j < kHaloAhead; ++j) {
    const int at = static_cast<int>(threadIdx.x) + j * kThreads;
    row.halo[j] = at < row.group.halo_count ? row.group.halo[at] : 0;
  }
#pragma unroll
  for (int j = 0; j < kEntriesMax; ++j)
    row.packed[j] = j < row.count ? packed[row.begin + kSliceRows * j] : 0;
  return row;
}

/// A block's tile, for which launch_products() has made room: what it leaves is the cache's.
template <typename Vector>
__device__ Vector* tile_of_block() {
  extern __shared__ float4 room[];
  return reinterpret_cast<Vector*>(room);
}

/// Brings the numbers of x at the group's rows and halo into the block's tile. Every thread calls
/// it.
template <typename Vector>
__device__ void fill_tile(const FetchedRow& row, const Vector* x, Vector* tile) {
  const Group& group = row.group;
  if (row.corner >= 0) tile[threadIdx.x] = x[row.corner];
#pragma unroll
  for (int j = 0; j < kHaloAhead; ++j) {
    const int at = static_cast<int>(threadIdx.x) + j * kThreads;
    if (at < group.halo_count) tile[group.count + at] = x[row.halo[j]];
  }
  for (int at = static_cast<int>(threadIdx.x) + kHaloAhead * kThreads; at < group.halo_count;
       at += kThreads)
    tile[group.count + at] = x[group.halo[at]];
  __syncthreads();
}

/// The row's off-diagonal entries times the tile.
__device__ inline float4 product_of(const FetchedRow& row, const float4* tile) {
  float4 sum = zero4();
#pragma unroll
  for (int j = 0; j < kEntriesUsual; ++j)
    sum = sum + value_of(row.packed[j]) * tile[local_of(row.packed[j])];
  if (row.count > kEntriesUsual) {
#pragma unroll
    for (int j = kEntriesUsual; j < kEntriesMax; ++j)
      sum = sum + value_of(row.packed[j]) * tile[local_of(row.packed[j])];
  }
  return sum;
}

__device__ inline Double3 exactly(float4 a) {
  return to_double(a);
}
__device__ inline Double3 exactly(Double3 a) {
  return a;
}

/// S of the finest depth to twice the digits of a float: packed entries, what they leave, and row
/// sums.
struct ExactMatrix {
  const uint32_t* packed;
  const float* rest;
  const double* row_sum;
};

/// The row times the tile as Σ_j S_ij (x_j − x_i) + m_i x_i, which loses nothing for smooth x.
template <typename Vector>
__device__ Double3 product_of(const FetchedRow& row, const ExactMatrix& matrix,
                              const Vector* tile) {
  constexpr int kChunk = 9;
  const Double3 here = exactly(tile[threadIdx.x]);
  Double3 sum = matrix.row_sum[row.corner] * here;
#pragma unroll
  for (int first = 0; first < kEntriesMax; first += kChunk) {
    if (first >= row.count) break;
    float rest[kChunk];
#pragma unroll
    for (int j = first; j < first + kChunk && j < kEntriesMax; ++j)
      rest[j - first] = j < row.count ? matrix.rest[row.begin + kSliceRows * j] : 0;
#pragma unroll
    for (int j = first; j < first + kChunk && j < kEntriesMax; ++j) {
      const double entry =
          static_cast<double>(value_of(row.packed[j])) + static_cast<double>(rest[j - first]);
      sum = sum + entry * (exactly(tile[local_of(row.packed[j])]) - here);
    }
  }
  return sum;
}

/// Starts blocks for a depth's groups, with a tile of such vectors each.
template <typename Vector, typename... Params, typename... Args>
void launch_products(Stream& stream, void (*kernel)(Params...), const Rows& rows, int32_t blocks,
                     Args... args) {
  launch_blocks(stream, kernel, dim3(static_cast<unsigned>(blocks)), dim3(kThreads),
                rows.tile_max * sizeof(Vector), args...);
}

/// Starts one block for each group of rows, without a tile.
template <typename... Params, typename... Args>
void launch_groups(Stream& stream, void (*kernel)(Params...), const Rows& rows, Args... args) {
  launch(stream, kernel, static_cast<int64_t>(rows.group_count) * kThreads, args...);
}

}  // namespace burnish::cuda
