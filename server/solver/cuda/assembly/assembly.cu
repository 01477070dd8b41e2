#include "server/solver/cuda/assembly/assembly.h"
#include "server/solver/cuda/assembly/gather_rows.h"
#include "server/solver/cuda/assembly/gradient_shares.h"
#include "server/solver/cuda/assembly/irregular_rows.h"
#include "server/solver/cuda/products/products.h"
#include "server/solver/hierarchy/pinned_below.h"

namespace burnish::cuda {

namespace {

constexpr int kMedianSamples = Pinning::kSamples;

// Returns a cell's share of a diagonal.
__device__ double diagonal_of(const CellSquares<double>& cells, int64_t cell, int a) {
  double diagonal = own_of(cells, cell, a);
#pragma unroll
  for (int step = 1; step < 8; ++step) diagonal -= pair_of(cells, cell, pair_index(a, a ^ step));
  return diagonal;
}

// Finds the median of an even sample in one block, with eight threads for each number: the median
// is the number that half of the others precede. Leaves out irregular rows. Takes the numbers of
// rows that are not listed from last time.
__global__ void pinned_below_kernel(Topology topology, CellSquares<double> cells, Pinning* pinning,
                                    BlockList listed) {
  __shared__ float sample[kMedianSamples];
  let_next_start();
  const int stride = max(1, topology.own_count / kMedianSamples);
  const int count = min(kMedianSamples, topology.own_count / stride);
  const auto t = static_cast<int>(threadIdx.x / 8), a = static_cast<int>(threadIdx.x % 8);
  const int32_t cell = t < count ? topology.cells_of_corner[t * stride].at[a] : -1;
  await_previous();
  auto diagonal = cell >= 0 ? static_cast<float>(diagonal_of(cells, cell, a)) : 0.0f;
  for (int offset = 4; offset > 0; offset /= 2)
    diagonal += __shfl_xor_sync(0xffffffffu, diagonal, offset);
  const bool is_sample =
      (__ballot_sync(0xffffffffu, cell >= 0) >> threadIdx.x % 32 / 8 * 8 & 0xffu) != 0;
  float mine = is_sample ? diagonal : __int_as_float(0x7f800000);  // infinity
  if (!is_listed(listed, t * stride / topology.rows.group_rows)) mine = pinning->sample[t];
  __syncwarp();
  if (a == 0) pinning->sample[t] = mine;
  sample[t] = mine;
  const int sampled = __syncthreads_count(is_sample) / 8;
  int rank = 0;
#pragma unroll
  for (int k = a; k < kMedianSamples; k += 8)
    rank += static_cast<int>(sample[k] < mine || (sample[k] == mine && k < t));
  for (int offset = 4; offset > 0; offset /= 2) rank += __shfl_xor_sync(0xffffffffu, rank, offset);
  if (a == 0 && rank == sampled / 2)
    pinning->below = is_sample ? static_cast<float>(kPinnedBelow) * mine : 0;
}

enum class Gradients { kNone, kFloats, kWithRests };

template <Gradients kGradients>
__device__ __forceinline__ void assemble_group(const CellSquares<double>& cells, const Depth& depth,
                                               const BesideMatrix& beside, const float4* probe,
                                               const float* pinned_below, int32_t block) {
  __shared__ RowRoom room;
  float4* tile = tile_of_block<float4>();
  const Group group = group_of(depth.topology.rows, block);
  const int32_t corner = row_of(group);
  await_previous();
  if (probe != nullptr) fill_tile(group, probe, tile);
  if (corner < 0) return;
  const GatheredRow<double> row = gather_row(cells, depth.topology.cells_of_corner[corner]);
  const auto diagonal = static_cast<float>(row.diagonal);
  depth.system.diagonal[corner] = diagonal;
  const bool is_free = diagonal > *pinned_below && corner < depth.topology.known_count;
  depth.inverse_diagonal[corner] = is_free ? 1 / diagonal : 0;
  if (beside.row_sum != nullptr) beside.row_sum[corner] = row.own;
  float4 product = zero4();
  if (probe != nullptr) product = diagonal * tile[threadIdx.x];
  const Rows& rows = depth.topology.rows;
  const auto rest_of = [](double value) {
    return value - value_of(pack(static_cast<float>(value), 0));
  };
  if (depth.system.rest != nullptr)
    store_row(
        rows, corner, row, room, [&](double value) { return static_cast<float>(rest_of(value)); },
        [&](int64_t k, float rest, uint32_t) { depth.system.rest[k] = rest; });
  if (depth.remainder != nullptr)
    store_row(
        rows, corner, row, room,
        [&](double value) {
          return static_cast<float>(rest_of(value) - static_cast<float>(rest_of(value)));
        },
        [&](int64_t k, float remainder, uint32_t) { depth.remainder[k] = remainder; });
  const auto as_float = [](double value) { return static_cast<float>(value); };
  store_row(rows, corner, row, room, as_float, [&](int64_t k, float value, uint32_t local) {
    const uint32_t packed = pack(value, local);
    depth.system.packed[k] = packed;
    if (probe != nullptr) product = product + value_of(packed) * tile[local];
  });
  if (probe != nullptr) depth.r[corner] = product;
  if constexpr (kGradients != Gradients::kNone)
    beside.per_slider[corner] = sum_shares<kGradients == Gradients::kWithRests>(
        beside.gradients, depth.topology.cells_of_corner[corner]);
}

template <Gradients kGradients, bool kListed>
__global__ void __launch_bounds__(kThreads, kListed ? 4 : 6)
    assemble_kernel(CellSquares<double> cells, Depth depth, BesideMatrix beside,
                    const float4* probe, const float* pinned_below, BlockList listed) {
  let_next_start();
  for_own_blocks<kListed>(listed, [&](int32_t block) {
    assemble_group<kGradients>(cells, depth, beside, probe, pinned_below, block);
  });
}

template <bool kListed>
auto choose_kernel(const BesideMatrix& beside) {
  if (beside.gradients.rests != nullptr) return assemble_kernel<Gradients::kWithRests, kListed>;
  if (beside.gradients.numbers != nullptr) return assemble_kernel<Gradients::kFloats, kListed>;
  return assemble_kernel<Gradients::kNone, kListed>;
}

}  // namespace

void assemble(Stream& stream, const CellSquares<double>& cells, const Depth& depth,
              const BesideMatrix& beside, const float4* probe, Pinning* pinning,
              const BlockList& listed) {
  launch_blocks(stream, pinned_below_kernel, dim3(1), dim3(8 * kMedianSamples), 0, depth.topology,
                cells, pinning, listed);
  const Rows& rows = depth.topology.rows;
  const float* const pinned_below = &pinning->below;
  launch_products<float4>(
      stream, listed.lists ? choose_kernel<true>(beside) : choose_kernel<false>(beside), rows,
      blocks_for(rows.group_count, listed).x, cells, depth, beside, probe, pinned_below, listed);
  assemble_irregular_rows(stream, cells, depth, probe, pinned_below, listed);
}

}  // namespace burnish::cuda
