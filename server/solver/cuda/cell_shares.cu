#include "server/solver/cell_matrix.h"
#include "server/solver/cuda/cell_shares.h"
#include "server/solver/cuda/half_way.h"
#include "server/solver/cuda/kernel.h"

namespace burnish::cuda {

namespace {

// A target has a warp: four groups of eight threads, of which each does every fourth share, a
// thread for each row.
constexpr int kWarpGroups = 4;

// The weights of a cell's corners at its half-way points.
struct HalfWay {
  float at[27][8];
};

__device__ void fill(HalfWay& weights) {
  for (auto i = static_cast<int>(threadIdx.x); i < 27 * 8; i += kThreads)
    weights.at[i / 8][i % 8] = half_way_weight(i / 8, i % 8);
  __syncthreads();
}

// Row a of N, and of a cell its row sum: what else the diagonal follows from.
struct SourceRow {
  float entry[8];
  float row_sum;
};

template <typename Real>
__device__ SourceRow cell_row(const CellSquares<Real>& cells, int32_t cell, int a) {
  SourceRow row;
  row.row_sum = static_cast<float>(own_of(cells, cell, a));
  float diagonal = row.row_sum;
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    row.entry[b] =
        b == a ? 0 : static_cast<float>(pair_of(cells, cell, pair_index(a, b == a ? a ^ 1 : b)));
    diagonal -= row.entry[b];
  }
#pragma unroll
  for (int b = 0; b < 8; ++b)
    if (b == a) row.entry[b] = diagonal;
  return row;
}

template <typename Real>
__device__ SourceRow tie_row(const CellSquares<Real>& cells, int64_t tie, int a,
                             bool is_transposed) {
  const Real* numbers = cells.numbers + cells.kNumbers * cells.cells + 64 * tie;
  SourceRow row = {};
#pragma unroll
  for (int b = 0; b < 8; ++b)
    row.entry[b] = static_cast<float>(numbers[is_transposed ? 8 * b + a : 8 * a + b]);
  return row;
}

// The threads of a group, and what one of them has.
struct Group {
  unsigned mask;
  int first_lane;

  template <typename T>
  __device__ T from(T number, int thread) const {
    return __shfl_sync(mask, number, first_lane + thread);
  }
};

// Adds row v = `a` of Lᵀ N R, and in [8] of its row sum. R's rows add up to their weights: what N's
// row sum has of a common weight needs no difference of large numbers.
template <typename Real>
__device__ void add_share(const CellSquares<Real>& fine, const Shares& shares,
                          const CellShare& share, const HalfWay& half_way, const Group& group,
                          int a, float (&sum)[9]) {
  const bool is_cell = share.source < fine.cells;
  const SourceRow row = is_cell
                            ? cell_row(fine, share.source, a)
                            : tie_row(fine, share.source - fine.cells, a, share.is_transposed != 0);
  const float left_weight = shares.part[share.left].weight[a],
              right_weight = shares.part[share.right].weight[a];
  const int left_place = shares.part[share.left].place[a],
            right_place = shares.part[share.right].place[a];
  const float common = is_cell ? right_weight : 0;
  float product[9] = {};
  product[8] = row.row_sum * common;
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    const float weight = group.from(right_weight, b);
    const int place = group.from(right_place, b);
    product[8] += row.entry[b] * (weight - common);
#pragma unroll
    for (int w = 0; w < 8; ++w) product[w] += row.entry[b] * weight * half_way.at[place][w];
  }
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    const float weight = group.from(left_weight, b) * half_way.at[group.from(left_place, b)][a];
#pragma unroll
    for (int w = 0; w < 9; ++w) sum[w] += weight * group.from(product[w], b);
  }
}

template <typename Real>
__global__ void add_shares_kernel(Shares shares, CellSquares<Real> fine,
                                  CellSquares<float> coarse) {
  __shared__ HalfWay half_way;
  let_next_start();
  fill(half_way);
  const int64_t number = thread_index() / 32;
  await_previous();
  if (number >= shares.target_count) return;
  const auto lane = static_cast<int>(threadIdx.x % 32);
  const int a = lane % 8;
  const Group group = {0xffu << lane / 8 * 8, lane / 8 * 8};
  float sum[9] = {};
  for (int32_t k = shares.start[number] + lane / 8; k < shares.start[number + 1]; k += kWarpGroups)
    add_share(fine, shares, shares.share[k], half_way, group, a, sum);
#pragma unroll
  for (int w = 0; w < 9; ++w)
    for (int offset = 8; offset < 32; offset *= 2)
      sum[w] += __shfl_xor_sync(0xffffffffu, sum[w], offset);
  if (lane >= 8) return;
  const int64_t target = shares.target[number];
  if (target >= coarse.cells) {
    float* tie = coarse.numbers + coarse.kNumbers * coarse.cells + 64 * (target - coarse.cells);
#pragma unroll
    for (int w = 0; w < 8; ++w) tie[8 * a + w] = sum[w];
    return;
  }
#pragma unroll
  for (int w = 0; w < 8; ++w)
    if (w > a) pair_of(coarse, target, pair_index(a, w)) += sum[w];
  own_of(coarse, target, a) += sum[8];
}

}  // namespace

template <typename Real>
void add_shares(Stream& stream, const Shares& shares, const CellSquares<Real>& fine,
                const CellSquares<float>& coarse) {
  launch(stream, add_shares_kernel<Real>, int64_t{32} * shares.target_count, shares, fine, coarse);
}

template void add_shares(Stream&, const Shares&, const CellSquares<double>&,
                         const CellSquares<float>&);
template void add_shares(Stream&, const Shares&, const CellSquares<float>&,
                         const CellSquares<float>&);

}  // namespace burnish::cuda
