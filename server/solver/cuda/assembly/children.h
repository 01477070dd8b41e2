#pragma once

#include "server/solver/cuda/device/kernel.h"
#include "server/solver/hierarchy/block_sizes.h"
#include "server/solver/hierarchy/cell_matrix.h"

// Σ Pᵀ K P over the children of coarse cells; reads each child once through a block's shared
// memory.

namespace burnish::cuda {

/// The warps of a block divide a cell's numbers: this many each, one after the other.
inline constexpr int kWarps = kThreads / 32;
inline constexpr int kEach = CellSquares<double>::kNumbers / kWarps;
inline constexpr int kPairsOfEach = kPairsPerCell / kWarps;

__device__ inline int number_of(int n) {
  return n * kWarps + static_cast<int>(threadIdx.x / 32);
}

/// The children of a block's parents; each is read once.
inline constexpr int kParents = kThreads / 8;
inline constexpr int kChildren = 8 * kParents;
inline constexpr int kRounds = kChildren / 32;
static_assert(kParents == kPartsOfBlock);
struct Children {
  const int32_t* cell;
  int count;
  int32_t before;  // children before these
};

__device__ inline Children children_of_block(const Topology& coarse, int32_t block) {
  const int32_t parent = block * kParents;
  const int32_t first = coarse.child_start[parent];
  const int32_t end = coarse.child_start[min(parent + kParents, coarse.cell_count)];
  return {coarse.child + first, end - first, first};
}

struct ChildNumbers {
  int octant[kChildren];
  double numbers[CellSquares<double>::kNumbers][kChildren + 1];  // one more avoids bank conflicts
};

/// Reads children in rounds of 32. load(cell, number, is_pair) loads the sources of a number.
/// make(round, cell, n, loaded) makes the number; n is its index among the thread's numbers. A
/// thread loads all sources of a child at once. After its first loads every thread calls prepare().
template <int kUnroll, typename Load, typename Prepare, typename Make>
__device__ void read_children(const Children& children, const uint8_t* octant, Load&& load,
                              Prepare&& prepare, Make&& make, ChildNumbers& read) {
  for (int i = static_cast<int>(threadIdx.x); i < children.count; i += kThreads)
    read.octant[i] = octant[children.cell[i]];
#pragma unroll kUnroll
  for (int round = 0; round < kRounds; ++round) {
    if (32 * round >= children.count) break;
    const int i = 32 * round + static_cast<int>(threadIdx.x % 32);
    const int64_t cell = children.cell[min(i, children.count - 1)];
    decltype(load(cell, 0, true)) loaded[kEach];
#pragma unroll
    for (int n = 0; n < kEach; ++n) loaded[n] = load(cell, number_of(n), n < kPairsOfEach);
    if (round == 0) prepare();
    if (i >= children.count) continue;
#pragma unroll
    for (int n = 0; n < kEach; ++n) read.numbers[number_of(n)][i] = make(round, cell, n, loaded[n]);
  }
  __syncthreads();
}

/// Reads row a of K; its last number is the row sum.
__device__ inline void read_row(const ChildNumbers& children, int i, int a, double (&row)[9]) {
  row[8] = children.numbers[kPairsPerCell + a][i];
  double diagonal = row[8];
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    row[b] = a == b ? 0 : children.numbers[pair_index(a, b)][i];
    diagonal -= row[b];
  }
#pragma unroll
  for (int b = 0; b < 8; ++b)
    if (a == b) row[b] = diagonal;
}

/// Does K P within a row. Along each axis the child's corner in the parent's middle gives half to
/// each side.
__device__ inline void restrict_columns(int octant, double (&row)[9]) {
#pragma unroll
  for (int bit = 1; bit < 8; bit *= 2)
#pragma unroll
    for (int b = 0; b < 8; ++b) {
      if (b & bit) continue;
      double &low = row[b], &high = row[b | bit];
      const double half = 0.5 * (octant & bit ? low : high);
      low = octant & bit ? half : low + half;
      high = octant & bit ? high + half : half;
    }
}

/// Does Pᵀ from the left, among the eight neighbouring threads that hold a row each.
__device__ inline void restrict_rows(int octant, int a, unsigned group, double (&row)[9]) {
#pragma unroll
  for (int bit = 1; bit < 8; bit *= 2) {
    const bool in_middle = ((a ^ octant) & bit) != 0;
#pragma unroll
    for (int b = 0; b < 9; ++b) {
      const double other = __shfl_xor_sync(group, row[b], bit);
      row[b] = in_middle ? 0.5 * row[b] : row[b] + 0.5 * other;
    }
  }
}

/// Uses eight threads per coarse cell of the block, one per row.
__device__ inline void sum_children(const Topology& coarse, int32_t block, const Children& children,
                                    const ChildNumbers& read,
                                    const CellSquares<double>& coarse_cells) {
  const int64_t parent = int64_t{block} * kParents + threadIdx.x / 8;
  if (parent >= coarse_cells.cells) return;
  const int a = static_cast<int>(threadIdx.x % 8);
  const unsigned group = 0xffu << (threadIdx.x % 32 / 8 * 8);
  double sum[9] = {};
  for (int32_t k = coarse.child_start[parent]; k < coarse.child_start[parent + 1]; ++k) {
    const int i = k - children.before;
    double row[9];
    read_row(read, i, a, row);
    restrict_columns(read.octant[i], row);
    restrict_rows(read.octant[i], a, group, row);
#pragma unroll
    for (int b = 0; b < 9; ++b) sum[b] += row[b];
  }
#pragma unroll
  for (int b = 0; b < 8; ++b)
    if (b > a) pair_of(coarse_cells, parent, pair_index(a, b)) = sum[b];
  own_of(coarse_cells, parent, a) = sum[8];
}

}  // namespace burnish::cuda
