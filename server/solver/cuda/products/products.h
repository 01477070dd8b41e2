#pragma once

#include "server/solver/cuda/device/kernel.h"
#include "server/solver/cuda/device/packed.h"

// Products of a matrix with a vector: a block of threads for each group of rows, a thread for each
// row. A thread fetches all data that a cycle does not change before it waits for the previous
// kernel. After the wait a small depth's product is hardly more than one read of the vector.

namespace burnish::cuda {

inline constexpr int kEntriesUsual = 18;  // rows inside the surface have 17 or 26
inline constexpr int kHaloAhead = 2;      // per thread; enough for most groups

/// The rows of a block.
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

/// Returns the corner of a column from its place in the group's tile.
__device__ inline int32_t column_of(const Group& group, uint32_t local) {
  const auto at = static_cast<int32_t>(local);
  return at < group.count ? group.first + at : group.halo[at - group.count];
}

/// Returns the corner of this thread's row, or -1.
__device__ inline int32_t row_of(const Group& group) {
  const auto t = static_cast<int32_t>(threadIdx.x);
  return t < group.count ? group.first + t : -1;
}

/// A thread's part of its group's tile: its row's number and some of the halo's.
struct TilePart {
  Group group;
  int32_t corner;  // -1 for none
  int32_t halo[kHaloAhead];
};

__device__ inline TilePart fetch_part(const Rows& rows, int32_t g) {
  TilePart part;
  part.group = group_of(rows, g);
  part.corner = row_of(part.group);
#pragma unroll
  for (int j = 0; j < kHaloAhead; ++j) {
    const int at = static_cast<int>(threadIdx.x) + j * kThreads;
    part.halo[j] = at < part.group.halo_count ? part.group.halo[at] : 0;
  }
  return part;
}

/// Also holds the entries of its row.
struct FetchedRow : TilePart {
  int count;      // entries
  int64_t begin;  // first entry
  uint32_t packed[kEntriesMax];
};

__device__ inline FetchedRow fetch_row(const Rows& rows, const uint32_t* packed, int32_t g) {
  FetchedRow row;
  static_cast<TilePart&>(row) = fetch_part(rows, g);
  row.count = row.corner >= 0 ? __popc(rows.mask[row.corner]) : 0;
  row.begin = row.corner >= 0 ? row_begin(rows, row.corner) : 0;
#pragma unroll
  for (int j = 0; j < kEntriesMax; ++j)
    row.packed[j] = j < row.count ? packed[row.begin + kSliceRows * j] : 0;
  return row;
}

/// Returns a block's tile. launch_products() has made room for it; the cache gets the rest.
template <typename Vector>
__device__ Vector* tile_of_block() {
  extern __shared__ float4 room[];
  return reinterpret_cast<Vector*>(room);
}

/// Fills the block's tile with the numbers of x at the group's rows and halo. Every thread calls
/// it.
template <typename Vector>
__device__ void fill_tile(const Group& group, const Vector* x, Vector* tile) {
  for (auto at = static_cast<int32_t>(threadIdx.x); at < group.count + group.halo_count;
       at += kThreads)
    tile[at] = x[column_of(group, static_cast<uint32_t>(at))];
  __syncthreads();
}

/// Fills the block's tile with number_of(corner) at the group's rows and halo. Every thread calls
/// it.
template <typename Number, typename NumberOf>
__device__ void fill_tile_with(const TilePart& part, NumberOf&& number_of, Number* tile) {
  const Group& group = part.group;
  if (part.corner >= 0) tile[threadIdx.x] = number_of(part.corner);
#pragma unroll
  for (int j = 0; j < kHaloAhead; ++j) {
    const int at = static_cast<int>(threadIdx.x) + j * kThreads;
    if (at < group.halo_count) tile[group.count + at] = number_of(part.halo[j]);
  }
  for (int at = static_cast<int>(threadIdx.x) + kHaloAhead * kThreads; at < group.halo_count;
       at += kThreads)
    tile[group.count + at] = number_of(group.halo[at]);
  __syncthreads();
}

/// Does the same with the numbers of x.
template <typename Vector>
__device__ void fill_tile(const TilePart& part, const Vector* x, Vector* tile) {
  fill_tile_with(
      part, [x](int32_t corner) { return x[corner]; }, tile);
}

/// Returns the row's off-diagonal entries times the tile.
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

/// Returns the rests of the row's packed entries times the tile.
__device__ inline float4 rest_of_product(const float* rest, const FetchedRow& row,
                                         const float4* tile) {
  float4 sum = zero4();
#pragma unroll
  for (int j = 0; j < kEntriesMax; ++j)
    if (j < row.count) sum = sum + rest[row.begin + kSliceRows * j] * tile[local_of(row.packed[j])];
  return sum;
}

__device__ inline Double3 exactly(float4 a) {
  return to_double(a);
}
__device__ inline Double3 exactly(Double3 a) {
  return a;
}

/// S of the finest depth to 38 bits: packed entries, their rests, and row sums. With the rounding
/// of the rests it has all of double's bits.
struct ExactMatrix {
  const uint32_t* packed;
  const float *rest, *remainder;
  const double* row_sum;
};

/// Returns the row times the tile as Σ_j S_ij (x_j − x_i) + m_i x_i, which loses nothing for smooth
/// x.
template <bool kRemainder, typename Vector>
__device__ Double3 product_of(const FetchedRow& row, const ExactMatrix& matrix,
                              const Vector* tile) {
  constexpr int kChunk = 9;
  const Double3 here = exactly(tile[threadIdx.x]);
  Double3 sum = matrix.row_sum[row.corner] * here;
#pragma unroll
  for (int first = 0; first < kEntriesMax; first += kChunk) {
    if (first >= row.count) break;
    float rest[kChunk], remainder[kChunk];
#pragma unroll
    for (int j = first; j < first + kChunk && j < kEntriesMax; ++j) {
      const int64_t at = row.begin + kSliceRows * j;
      rest[j - first] = j < row.count ? matrix.rest[at] : 0;
      if (kRemainder) remainder[j - first] = j < row.count ? matrix.remainder[at] : 0;
    }
#pragma unroll
    for (int j = first; j < first + kChunk && j < kEntriesMax; ++j) {
      double entry =
          static_cast<double>(value_of(row.packed[j])) + static_cast<double>(rest[j - first]);
      if (kRemainder) entry += static_cast<double>(remainder[j - first]);
      sum = sum + entry * (exactly(tile[local_of(row.packed[j])]) - here);
    }
  }
  return sum;
}

/// Starts blocks for a depth's groups, each with a tile of such vectors.
template <typename Vector, typename... Params, typename... Args>
void launch_products(Stream& stream, void (*kernel)(Params...), const Rows& rows, int32_t blocks,
                     Args... args) {
  launch_blocks(stream, kernel, dim3(static_cast<unsigned>(blocks)), dim3(kThreads),
                rows.tile_max * sizeof(Vector), args...);
}

}  // namespace burnish::cuda
