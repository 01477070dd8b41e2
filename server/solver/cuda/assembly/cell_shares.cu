#include "server/solver/cuda/assembly/cell_shares.h"
#include "server/solver/cuda/assembly/half_way.h"
#include "server/solver/cuda/device/kernel.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cuda {

namespace {

// A share takes a group of eight threads, one for each row. A target has kGroups of them, and each
// does every kGroups th share. A target gets all groups of a warp while they fit on the device at
// once, else one: most targets have a share or two.
constexpr int kWarpGroups = 4;
constexpr int32_t kTargetsAtOnce = 4096;

// The weights of a cell's corners at its half-way points.
struct HalfWay {
  float at[27][8];
};

__device__ void fill(HalfWay& weights) {
  for (auto i = static_cast<int>(threadIdx.x); i < 27 * 8; i += kThreads)
    weights.at[i / 8][i % 8] = half_way_weight(i / 8, i % 8);
  __syncthreads();
}

// A thread's part of a share: the weights and places of its corner.
struct FetchedShare {
  int32_t source;
  bool is_transposed;
  float left_weight, right_weight;
  int left_place, right_place;
};

__device__ FetchedShare fetch_share(const Shares& shares, int32_t k, int a) {
  const CellShare share = shares.share[k];
  const CellPart &left = shares.part[share.left], &right = shares.part[share.right];
  return {share.source,  share.is_transposed != 0, left.weight[a], right.weight[a], left.place[a],
          right.place[a]};
}

// Row a of N and its sum.
struct SourceRow {
  double entry[8];
  double row_sum;
};

__device__ SourceRow read_row(const CellSquares<double>& cells, const FetchedShare& share, int a) {
  SourceRow row;
  if (share.source < cells.cells) {
    row.row_sum = own_of(cells, share.source, a);
#pragma unroll
    for (int b = 0; b < 8; ++b)
      if (b != a) row.entry[b] = pair_of(cells, share.source, pair_index(a, b));
    double diagonal = row.row_sum;
#pragma unroll
    for (int b = 0; b < 8; ++b)
      if (b != a) diagonal -= row.entry[b];
#pragma unroll
    for (int b = 0; b < 8; ++b)
      if (b == a) row.entry[b] = diagonal;
    return row;
  }
  const double* tie =
      cells.numbers + cells.kNumbers * cells.cells + 64 * (share.source - cells.cells);
  row.row_sum = 0;
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    row.entry[b] = tie[share.is_transposed ? 8 * b + a : 8 * a + b];
    row.row_sum += row.entry[b];
  }
  return row;
}

// The threads of a group, and the values of one of them.
struct Group {
  unsigned mask;
  int first_lane;

  template <typename T>
  __device__ T from(T number, int thread) const {
    return __shfl_sync(mask, number, first_lane + thread);
  }
};

// Adds row v = `a` of Lᵀ N R, and in [8] its row sum. R's rows add up to their weights, so N's row
// sum times a common weight needs no difference of large numbers.
__device__ void add_share(const FetchedShare& share, const SourceRow& row, const HalfWay& half_way,
                          const Group& group, int a, double (&sum)[9]) {
  double product[9] = {};
  product[8] = row.row_sum * share.right_weight;
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    const float weight = group.from(share.right_weight, b);
    const int place = group.from(share.right_place, b);
    product[8] += row.entry[b] * (weight - share.right_weight);
#pragma unroll
    for (int w = 0; w < 8; ++w) product[w] += row.entry[b] * weight * half_way.at[place][w];
  }
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    const float weight =
        group.from(share.left_weight, b) * half_way.at[group.from(share.left_place, b)][a];
#pragma unroll
    for (int w = 0; w < 9; ++w) sum[w] += weight * group.from(product[w], b);
  }
}

// Adds row a of the target's numbers.
__device__ void add_to(const CellSquares<double>& cells, int64_t target, int a,
                       const double (&sum)[9]) {
  if (target >= cells.cells) {
    double* tie = cells.numbers + cells.kNumbers * cells.cells + 64 * (target - cells.cells);
#pragma unroll
    for (int w = 0; w < 8; ++w) tie[8 * a + w] = sum[w];
    return;
  }
#pragma unroll
  for (int w = 0; w < 8; ++w)
    if (w > a) pair_of(cells, target, pair_index(a, w)) += sum[w];
  own_of(cells, target, a) += sum[8];
}

template <int kGroups>
__global__ void add_shares_kernel(Shares shares, CellSquares<double> fine,
                                  CellSquares<double> coarse, BlockList listed) {
  __shared__ HalfWay half_way;
  let_next_start();
  const int64_t number = thread_index() / (8 * kGroups);
  const bool is_there = number < shares.target_count && is_listed(listed, shares.block[number]);
  const auto lane = static_cast<int>(threadIdx.x % 32);
  const int a = lane % 8;
  const Group group = {0xffu << lane / 8 * 8, lane / 8 * 8};
  int32_t k = is_there ? shares.start[number] + lane / 8 % kGroups : 0;
  const int32_t end = is_there ? shares.start[number + 1] : 0;
  FetchedShare next = {};
  if (k < end) next = fetch_share(shares, k, a);
  fill(half_way);
  await_previous();
  double sum[9] = {};
  while (k < end) {
    const FetchedShare share = next;
    const SourceRow row = read_row(fine, share, a);
    k += kGroups;
    if (k < end) next = fetch_share(shares, k, a);
    add_share(share, row, half_way, group, a, sum);
  }
  __syncwarp();
#pragma unroll
  for (int w = 0; w < 9; ++w)
    for (int offset = 8; offset < 8 * kGroups; offset *= 2)
      sum[w] += __shfl_xor_sync(0xffffffffu, sum[w], offset);
  if (is_there && lane / 8 % kGroups == 0) add_to(coarse, shares.target[number], a, sum);
}

}  // namespace

void add_shares(Stream& stream, const Shares& shares, const CellSquares<double>& fine,
                const CellSquares<double>& coarse, const BlockList& listed) {
  if (shares.target_count <= kTargetsAtOnce)
    launch(stream, add_shares_kernel<kWarpGroups>, int64_t{8 * kWarpGroups} * shares.target_count,
           shares, fine, coarse, listed);
  else
    launch(stream, add_shares_kernel<1>, int64_t{8} * shares.target_count, shares, fine, coarse,
           listed);
}

}  // namespace burnish::cuda
