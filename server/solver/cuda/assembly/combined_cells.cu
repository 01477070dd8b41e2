#include "server/solver/cuda/assembly/cell_alpha.h"
#include "server/solver/cuda/assembly/cell_gradients.h"
#include "server/solver/cuda/assembly/cell_shares.h"
#include "server/solver/cuda/assembly/children.h"
#include "server/solver/cuda/assembly/combined_cells.h"
#include "server/solver/cuda/device/kernel.h"
#include "server/solver/cuda/mesh/mass_places.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cuda {

namespace {

// Numbers of at least one compare like their bits. A maximum does not depend on the order.
__device__ void keep_largest(float number, float* largest) {
  for (int offset = 16; offset > 0; offset /= 2)
    number = fmaxf(number, __shfl_xor_sync(0xffffffffu, number, offset));
  if (threadIdx.x % 32 == 0)
    atomicMax(reinterpret_cast<unsigned*>(largest), __float_as_uint(number));
}

__device__ CombineWeights weights_of(const Metric& metric, float2 alpha) {
  return combine_weights(alpha.x * metric.scale, alpha.y * metric.scale);
}

struct CellWeights {
  CombineWeights by;
  const HeldLine* line;  // null for none
};

// Also keeps what the metric asks for. Each warp of a block calls it as a whole; cell < 0 for none.
__device__ CellWeights take_weights(const Metric& metric, int64_t cell) {
  const float2 alpha = cell >= 0 ? alpha_of(*metric.alpha, metric.curvature, cell) : float2{1, 1};
  keep_largest(fmaxf(alpha.x / alpha.y, alpha.y / alpha.x), metric.anisotropy);
  return {weights_of(metric, alpha), cell >= 0 ? held_line_of(*metric.alpha, cell) : nullptr};
}

// A number's three integrals. Pairs come first, then row sums, which only the mass has. They never
// change, so their loads need not wait for earlier stores.
struct ThreeIntegrals {
  double mass, stiffness1, stiffness2;
};

__constant__ constexpr MassPlaces kMassPlaces = mass_places();

__device__ ThreeIntegrals integrals_of(const Integrals& integrals, int64_t cell, int number,
                                       bool is_pair) {
  constexpr int kFirstSum = Integrals::kMasses, kFirst = kFirstSum + Integrals::kRowSums;
  const auto integral = [&](int n) {
    return __ldg(integrals.numbers + n * integrals.cells + cell);
  };
  if (!is_pair) return {integral(kFirstSum + number - kPairsPerCell), 0, 0};
  return {integral(kMassPlaces.of_pair[number]), integral(kFirst + number),
          integral(kFirst + Integrals::kStiffnesses + number)};
}

__device__ double stiffness_of(const ThreeIntegrals& of, const CombineWeights& weights) {
  return weights.stiffness1 * of.stiffness1 + weights.stiffness2 * of.stiffness2;
}

__device__ double combine(const ThreeIntegrals& of, const CombineWeights& weights) {
  return weights.mass * of.mass + stiffness_of(of, weights);
}

__device__ double combine(const ThreeIntegrals& of, const CellWeights& weights, int number) {
  const double sum = combine(of, weights.by);
  if (weights.line == nullptr) return sum;
  return sum + held_line_weight(weights.by) * weights.line->number[number];
}

enum class Gradients { kNone, kFloats, kWithRests };

// Combines up to 32 cells in a block of threads: those from place `first` of a list on, or of all
// cells. Places end at `count`.
template <Gradients kGradients>
__device__ __forceinline__ void combine_cells(const Integrals& integrals, const Metric& metric,
                                              const CellSquares<double>& combined,
                                              const int32_t* list, int64_t first, int64_t count) {
  constexpr bool kAny = kGradients != Gradients::kNone;
  __shared__ CellWeights weights[32];
  __shared__ double stiffness[kAny ? kPairsPerCell : 1][32 + 1];  // one more avoids bank conflicts
  const auto lane = static_cast<int>(threadIdx.x % 32);
  const int64_t i = first + lane, there = min(i, count - 1);
  const int64_t cell = list != nullptr ? list[there] : there;
  ThreeIntegrals loaded[kEach];
#pragma unroll
  for (int n = 0; n < kEach; ++n)
    loaded[n] = integrals_of(integrals, cell, number_of(n), n < kPairsOfEach);
  if (threadIdx.x < 32) weights[lane] = take_weights(metric, i < count ? cell : -1);
  __syncthreads();
#pragma unroll
  for (int n = 0; n < kEach; ++n) {
    if (i < count)
      combined.numbers[number_of(n) * combined.cells + cell] =
          combine(loaded[n], weights[lane], number_of(n));
    if (kAny && n < kPairsOfEach)
      stiffness[number_of(n)][lane] = stiffness_of(loaded[n], weights[lane].by);
  }
  if (kAny) {
    __syncthreads();
    const auto of_pair = [&](int pair) { return stiffness[pair][lane]; };
    if (threadIdx.x < 32 && i < count)
      write_gradients<kGradients == Gradients::kWithRests>(of_pair, cell, metric.gradients);
  }
}

// Combines 32 cells per block: the listed cells, or all. It may run next to the kernel that
// combines all other cells. It needs none of that kernel's numbers, and both write the same values
// to the same places. Its wait only makes it end after that kernel.
template <Gradients kGradients>
__global__ void combine_kernel(Integrals integrals, Metric metric, CellSquares<double> combined,
                               const int32_t* list, int64_t count) {
  let_next_start();
  combine_cells<kGradients>(integrals, metric, combined, list, int64_t{blockIdx.x} * 32, count);
  await_previous();
}

// Combines the children of the listed blocks of cells above.
template <Gradients kGradients>
__global__ void combine_children_kernel(Integrals integrals, Metric metric,
                                        CellSquares<double> combined, Topology coarse,
                                        BlockList listed) {
  for_own_blocks<true>(listed, [&](int32_t block) {
    const Children children = children_of_block(coarse, block);
    for (int first = 0; first < children.count; first += 32) {
      combine_cells<kGradients>(integrals, metric, combined, children.cell, first, children.count);
      __syncthreads();
    }
  });
}

// Finds the largest ratio among all cells. If the curve is constant, only cells with their own α
// have one above 1.
__global__ void find_anisotropy_kernel(Metric metric, int64_t cells) {
  await_previous();
  const AlphaSource& source = *metric.alpha;
  const bool is_constant = source.point_count == 1;
  const int64_t count = is_constant ? source.own_count : cells;
  float largest = 1;
  for (int64_t i = thread_index(); i < count; i += int64_t{gridDim.x} * kThreads) {
    float2 alpha;
    if (is_constant)
      alpha = {source.own[i].alpha1, source.own[i].alpha2};
    else
      alpha = alpha_of(source, metric.curvature, i);
    largest = fmaxf(largest, fmaxf(alpha.x / alpha.y, alpha.y / alpha.x));
  }
  keep_largest(largest, metric.anisotropy);
}

// Does the same for sheets, as 8×8 matrices one after the other.
__global__ void combine_sheets_kernel(SheetIntegrals sheets, Metric metric, double* squares) {
  __shared__ CombineWeights weights[32];
  __shared__ double numbers[CellSquares<double>::kNumbers][32 + 1];
  let_next_start();
  const auto lane = static_cast<int32_t>(threadIdx.x % 32);
  const int64_t first = int64_t{blockIdx.x} * 32;
  const int64_t sheet = min(first + lane, sheets.integrals.cells - 1);
  ThreeIntegrals loaded[kEach];
#pragma unroll
  for (int n = 0; n < kEach; ++n)
    loaded[n] = integrals_of(sheets.integrals, sheet, number_of(n), n < kPairsOfEach);
  if (threadIdx.x < 32) {
    weights[lane] =
        weights_of(metric, alpha_of(*metric.alpha, metric.curvature, sheets.cell[sheet]));
  }
  __syncthreads();
#pragma unroll
  for (int n = 0; n < kEach; ++n) numbers[number_of(n)][lane] = combine(loaded[n], weights[lane]);
  __syncthreads();
  const auto count = static_cast<int>(min(int64_t{32}, sheets.integrals.cells - first));
  for (auto k = static_cast<int>(threadIdx.x); k < 64 * count; k += kThreads) {
    const int i = k / 64, a = k / 8 % 8, b = k % 8;
    double number = numbers[a == b ? kPairsPerCell + a : pair_index(a, b)][i];
    for (int step = 1; a == b && step < 8; ++step) number -= numbers[pair_index(a, a ^ step)][i];
    squares[64 * first + k] = number;
  }
  await_previous();
}

// The stiffness for the gradients waits in registers until the shared memory is free: with its own
// shared memory fewer blocks would run at once.
template <bool kGradients>
__device__ __forceinline__ void combine_and_down_sample(
    const Integrals& integrals, const Metric& metric, const CellSquares<double>& combined,
    const Topology& fine, const Topology& coarse, const CellSquares<double>& coarse_cells,
    int32_t block) {
  __shared__ ChildNumbers read;
  __shared__ CellWeights weights[kChildren];
  const Children children = children_of_block(coarse, block);
  await_previous();
  const auto t = static_cast<int>(threadIdx.x);
  const auto make_weights = [&] {
    weights[t] = take_weights(metric, t < children.count ? children.cell[t] : -1);
    __syncthreads();
  };
  const auto load = [&](int64_t cell, int number, bool is_pair) {
    return integrals_of(integrals, cell, number, is_pair);
  };
  float stiffness[kRounds][kPairsOfEach] = {};
  const auto make = [&](int round, int64_t cell, int n, const ThreeIntegrals& loaded) {
    const CellWeights& of = weights[32 * round + t % 32];
    if (kGradients && n < kPairsOfEach)
      stiffness[round][n] = static_cast<float>(stiffness_of(loaded, of.by));
    return combined.numbers[number_of(n) * combined.cells + cell] =
               combine(loaded, of, number_of(n));
  };
  read_children<kGradients ? kRounds : 1>(children, fine.octant, load, make_weights, make, read);
  sum_children(coarse, block, children, read, coarse_cells);
  if (!kGradients) return;
  __syncthreads();
#pragma unroll
  for (int round = 0; round < kRounds; ++round)
#pragma unroll
    for (int n = 0; n < kPairsOfEach; ++n)
      read.numbers[number_of(n)][32 * round + t % 32] = stiffness[round][n];
  __syncthreads();
  const auto of_pair = [&](int pair) { return static_cast<float>(read.numbers[pair][t]); };
  if (t < children.count) write_gradients<false>(of_pair, children.cell[t], metric.gradients);
}
static_assert(kChildren == kThreads);

template <bool kGradients, bool kListed>
__global__ void __launch_bounds__(kThreads, kListed ? 4 : 5)
    combine_and_down_sample_kernel(Integrals integrals, Metric metric, CellSquares<double> combined,
                                   Topology fine, Topology coarse, CellSquares<double> coarse_cells,
                                   BlockList listed) {
  let_next_start();
  for_own_blocks<kListed>(listed, [&](int32_t block) {
    combine_and_down_sample<kGradients>(integrals, metric, combined, fine, coarse, coarse_cells,
                                        block);
  });
}

template <bool kListed>
__global__ void down_sample_kernel(Topology fine, Topology coarse, CellSquares<double> fine_cells,
                                   CellSquares<double> coarse_cells, BlockList listed) {
  __shared__ ChildNumbers read;
  let_next_start();
  for_own_blocks<kListed>(listed, [&](int32_t block) {
    const Children children = children_of_block(coarse, block);
    await_previous();
    const auto load = [&](int64_t cell, int number, bool) {
      return fine_cells.numbers[number * fine_cells.cells + cell];
    };
    const auto keep = [](int, int64_t, int, double loaded) { return loaded; };
    read_children<1>(
        children, fine.octant, load, [] {}, keep, read);
    sum_children(coarse, block, children, read, coarse_cells);
  });
}

__global__ void tell_alpha_kernel(AlphaSource alpha, AlphaSource* to) {
  await_previous();
  *to = alpha;
}

}  // namespace

void tell_alpha(Stream& stream, const AlphaSource& alpha, AlphaSource* to) {
  launch_blocks(stream, tell_alpha_kernel, dim3(1), dim3(1), 0, alpha, to);
}

static Gradients gradients_of(const Metric& metric) {
  if (metric.gradients.numbers == nullptr) return Gradients::kNone;
  return metric.gradients.rests == nullptr ? Gradients::kFloats : Gradients::kWithRests;
}

// `list` null: all cells.
static void combine(Stream& stream, const Integrals& integrals, const Metric& metric,
                    const CellSquares<double>& combined, const int32_t* list, int64_t count) {
  auto* kernel = combine_kernel<Gradients::kNone>;
  if (gradients_of(metric) == Gradients::kFloats) kernel = combine_kernel<Gradients::kFloats>;
  if (gradients_of(metric) == Gradients::kWithRests) kernel = combine_kernel<Gradients::kWithRests>;
  launch(stream, kernel, kWarps * count, integrals, metric, combined, list, count);
}

void combine_integrals(Stream& stream, const Integrals& integrals, const Metric& metric,
                       const CellSquares<double>& combined) {
  combine(stream, integrals, metric, combined, nullptr, combined.cells);
}

static auto choose_down_sampling(bool gradients, bool is_listed) {
  if (is_listed)
    return gradients ? combine_and_down_sample_kernel<true, true>
                     : combine_and_down_sample_kernel<false, true>;
  return gradients ? combine_and_down_sample_kernel<true, false>
                   : combine_and_down_sample_kernel<false, false>;
}

void find_anisotropy(Stream& stream, const Metric& metric, int64_t cells) {
  const int64_t threads = std::min(cells, int64_t{kListingBlocksMax} * kThreads);
  launch(stream, find_anisotropy_kernel, threads, metric, cells);
}

void combine_integrals(Stream& stream, const Integrals& integrals, const SheetIntegrals& sheets,
                       const Metric& metric, const CellSquares<double>& combined,
                       const Topology& fine, const Topology& coarse,
                       const CellSquares<double>& coarse_cells, const BlockList& listed) {
  const Gradients gradients = gradients_of(metric);
  const bool is_listed = listed.lists != nullptr, has_rests = gradients == Gradients::kWithRests;
  const dim3 blocks = blocks_for(block_count(8 * coarse_cells.cells), listed);
  launch_blocks(stream, choose_down_sampling(gradients == Gradients::kFloats, is_listed), blocks,
                dim3(kThreads), 0, integrals, metric, combined, fine, coarse, coarse_cells, listed);
  // Rests need doubles, which take more registers than that kernel has. So all cells are
  // combined once more, with the same result.
  if (has_rests && is_listed)
    launch_blocks(stream, combine_children_kernel<Gradients::kWithRests>, blocks, dim3(kThreads), 0,
                  integrals, metric, combined, coarse, listed);
  if (has_rests && !is_listed)
    combine(stream, integrals, metric, combined, nullptr, combined.cells);
  else
    combine(stream, integrals, metric, combined, coarse.shares.apart, coarse.shares.apart_count);
  launch(stream, combine_sheets_kernel, kWarps * sheets.integrals.cells, sheets, metric,
         combined.numbers + combined.kNumbers * combined.cells);
}

void down_sample(Stream& stream, const Topology& fine, const Topology& coarse,
                 const CellSquares<double>& fine_cells, const CellSquares<double>& coarse_cells,
                 const BlockList& listed) {
  launch_blocks(stream, listed.lists ? down_sample_kernel<true> : down_sample_kernel<false>,
                blocks_for(block_count(8 * coarse_cells.cells), listed), dim3(kThreads), 0, fine,
                coarse, fine_cells, coarse_cells, listed);
  add_shares(stream, coarse.shares, fine_cells, coarse_cells, listed);
}

}  // namespace burnish::cuda
