#include "server/solver/cell_matrix.h"
#include "server/solver/cuda/cell_shares.h"
#include "server/solver/cuda/combined_cells.h"
#include "server/solver/cuda/kernel.h"
#include "server/solver/cuda/mass_places.h"

namespace burnish::cuda {

namespace {

// Numbers that are at least one compare as their bits do, and a largest has no order.
__device__ void keep_largest(float number, float* largest) {
  for (int offset = 16; offset > 0; offset /= 2)
    number = fmaxf(number, __shfl_xor_sync(0xffffffffu, number, offset));
  if (threadIdx.x % 32 == 0)
    atomicMax(reinterpret_cast<unsigned*>(largest), __float_as_uint(number));
}

__device__ float2 alpha_of(const Metric& metric, int64_t cell) {
  const UniformAlpha uniform = *metric.uniform;
  if (uniform.is_uniform) return {uniform.alpha1, uniform.alpha2};
  return {metric.alpha1[cell], metric.alpha2[cell]};
}

__device__ CombineWeights weights_of(const Metric& metric, float2 alpha) {
  return combine_weights(alpha.x * metric.scale, alpha.y * metric.scale);
}

// The same, and what is kept of the metric. Each warp of a block calls it whole; cell < 0 for none.
__device__ CombineWeights take_weights(const Metric& metric, int64_t cell) {
  const bool is_there = cell >= 0;
  const float2 alpha = is_there ? alpha_of(metric, cell) : float2{1, 1};
  const float a1 = alpha.x, a2 = alpha.y;
  if (is_there) metric.ratio[cell] = a2 / a1;
  keep_largest(fmaxf(a1 / a2, a2 / a1), metric.anisotropy);
  return weights_of(metric, alpha);
}

// A number's three integrals. Pairs come first, then row sums, which are the mass's alone. They
// never change: such loads need not wait for the stores before.
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
  if (!is_pair) return {integral(kFirstSum + number - 28), 0, 0};
  return {integral(kMassPlaces.of_pair[number]), integral(kFirst + number),
          integral(kFirst + Integrals::kStiffnesses + number)};
}

__device__ double combine(const ThreeIntegrals& of, const CombineWeights& weights) {
  return weights.mass * of.mass +
         (weights.stiffness1 * of.stiffness1 + weights.stiffness2 * of.stiffness2);
}

__global__ void combine_kernel(Integrals integrals, Metric metric, CellSquares<double> combined) {
  await_previous();
  const int64_t cell = thread_index() < combined.cells ? thread_index() : -1;
  const CombineWeights weights = take_weights(metric, cell);
  if (cell < 0) return;
#pragma unroll 7
  for (int pair = 0; pair < 28; ++pair)
    pair_of(combined, cell, pair) = combine(integrals_of(integrals, cell, pair, true), weights);
#pragma unroll
  for (int a = 0; a < 8; ++a)
    own_of(combined, cell, a) = combine(integrals_of(integrals, cell, 28 + a, false), weights);
}

// A cell's numbers are shared out among the warps of a block: so many each, one after the other.
constexpr int kWarps = kThreads / 32;
constexpr int kEach = CellSquares<float>::kNumbers / kWarps;
constexpr int kPairsOfEach = 28 / kWarps;

__device__ int number_of(int n) {
  return n * kWarps + static_cast<int>(threadIdx.x / 32);
}

// 32 cells a block. Beside the kernel that combines all other cells, none of whose numbers this one
// needs or touches: what it waits for is that it ends after it.
__global__ void combine_apart_kernel(Integrals integrals, Metric metric,
                                     CellSquares<double> combined, Shares shares) {
  __shared__ CombineWeights weights[32];
  let_next_start();
  const auto lane = static_cast<int32_t>(threadIdx.x % 32);
  const int32_t i = static_cast<int32_t>(blockIdx.x) * 32 + lane;
  const int64_t cell = shares.apart[min(i, shares.apart_count - 1)];
  ThreeIntegrals loaded[kEach];
#pragma unroll
  for (int n = 0; n < kEach; ++n)
    loaded[n] = integrals_of(integrals, cell, number_of(n), n < kPairsOfEach);
  if (threadIdx.x < 32) weights[lane] = take_weights(metric, i < shares.apart_count ? cell : -1);
  __syncthreads();
#pragma unroll
  for (int n = 0; n < kEach; ++n)
    if (i < shares.apart_count)
      combined.numbers[number_of(n) * combined.cells + cell] = combine(loaded[n], weights[lane]);
  await_previous();
}

// The same of sheets, as 8×8 matrices one after the other.
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
    weights[lane] = weights_of(metric, alpha_of(metric, sheets.cell[sheet]));
  }
  __syncthreads();
#pragma unroll
  for (int n = 0; n < kEach; ++n) numbers[number_of(n)][lane] = combine(loaded[n], weights[lane]);
  __syncthreads();
  const auto count = static_cast<int>(min(int64_t{32}, sheets.integrals.cells - first));
  for (auto k = static_cast<int>(threadIdx.x); k < 64 * count; k += kThreads) {
    const int i = k / 64, a = k / 8 % 8, b = k % 8;
    double number = numbers[a == b ? 28 + a : pair_index(a, b)][i];
    for (int step = 1; a == b && step < 8; ++step) number -= numbers[pair_index(a, a ^ step)][i];
    squares[64 * first + k] = number;
  }
  await_previous();
}

// The children of a block's parents, each read once.
constexpr int kParents = kThreads / 8;
constexpr int kChildren = 8 * kParents;
struct Children {
  const int32_t* cell;
  int count;
  int32_t before;  // of all children
};

__device__ Children children_of_block(const Topology& coarse) {
  const int32_t parent = static_cast<int32_t>(blockIdx.x) * kParents;
  const int32_t first = coarse.child_start[parent];
  const int32_t end = coarse.child_start[min(parent + kParents, coarse.cell_count)];
  return {coarse.child + first, end - first, first};
}

struct ChildNumbers {
  int octant[kChildren];
  float numbers[CellSquares<float>::kNumbers][kChildren + 1];  // one more: banks
};

// load(cell, number, is_pair) is what a number is made of by make(i, cell, number, loaded), i being
// the child's. A thread loads all that it has of a child at once; after its first loads it calls
// prepare(), as every thread does.
template <typename Load, typename Prepare, typename Make>
__device__ void read_children(const Children& children, const uint8_t* octant, Load&& load,
                              Prepare&& prepare, Make&& make, ChildNumbers& read) {
  for (int i = static_cast<int>(threadIdx.x); i < children.count; i += kThreads)
    read.octant[i] = octant[children.cell[i]];
  for (int first = 0; first < children.count; first += 32) {
    const int i = first + static_cast<int>(threadIdx.x % 32);
    const int64_t cell = children.cell[min(i, children.count - 1)];
    decltype(load(cell, 0, true)) loaded[kEach];
#pragma unroll
    for (int n = 0; n < kEach; ++n) loaded[n] = load(cell, number_of(n), n < kPairsOfEach);
    if (first == 0) prepare();
    if (i >= children.count) continue;
#pragma unroll
    for (int n = 0; n < kEach; ++n)
      read.numbers[number_of(n)][i] = static_cast<float>(make(i, cell, number_of(n), loaded[n]));
  }
  __syncthreads();
}

// Row a of K; its last number is the row sum.
__device__ void read_row(const ChildNumbers& children, int i, int a, float (&row)[9]) {
  row[8] = children.numbers[28 + a][i];
  float diagonal = row[8];
#pragma unroll
  for (int b = 0; b < 8; ++b) {
    row[b] = a == b ? 0 : children.numbers[pair_index(a, b)][i];
    diagonal -= row[b];
  }
#pragma unroll
  for (int b = 0; b < 8; ++b)
    if (a == b) row[b] = diagonal;
}

// K P within a row. Along each axis the child's corner in the parent's middle shares itself out by
// halves.
__device__ void restrict_columns(int octant, float (&row)[9]) {
#pragma unroll
  for (int bit = 1; bit < 8; bit *= 2)
#pragma unroll
    for (int b = 0; b < 8; ++b) {
      if (b & bit) continue;
      float &low = row[b], &high = row[b | bit];
      const float half = 0.5f * (octant & bit ? low : high);
      low = octant & bit ? half : low + half;
      high = octant & bit ? high + half : half;
    }
}

// Pᵀ from the left, among the eight neighbouring threads that hold a row each.
__device__ void restrict_rows(int octant, int a, unsigned group, float (&row)[9]) {
#pragma unroll
  for (int bit = 1; bit < 8; bit *= 2) {
    const bool in_middle = ((a ^ octant) & bit) != 0;
#pragma unroll
    for (int b = 0; b < 9; ++b) {
      const float other = __shfl_xor_sync(group, row[b], bit);
      row[b] = in_middle ? 0.5f * row[b] : row[b] + 0.5f * other;
    }
  }
}

// Eight threads per coarse cell, each with a row.
__device__ void sum_children(const Topology& coarse, const Children& children,
                             const ChildNumbers& read, const CellSquares<float>& coarse_cells) {
  const int64_t parent = thread_index() / 8;
  if (parent >= coarse_cells.cells) return;
  const int a = static_cast<int>(threadIdx.x % 8);
  const unsigned group = 0xffu << (threadIdx.x % 32 / 8 * 8);
  float sum[9] = {};
  for (int32_t k = coarse.child_start[parent]; k < coarse.child_start[parent + 1]; ++k) {
    const int i = k - children.before;
    float row[9];
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

__global__ void __launch_bounds__(kThreads, 5)
    combine_and_down_sample_kernel(Integrals integrals, Metric metric, CellSquares<double> combined,
                                   Topology fine, Topology coarse,
                                   CellSquares<float> coarse_cells) {
  __shared__ ChildNumbers read;
  __shared__ CombineWeights weights[kChildren];
  let_next_start();
  const Children children = children_of_block(coarse);
  await_previous();
  // The host's memory is far: what is here is loaded meanwhile.
  const auto fetch_weights = [&] {
    const auto t = static_cast<int>(threadIdx.x);
    weights[t] = take_weights(metric, t < children.count ? children.cell[t] : -1);
    __syncthreads();
  };
  const auto load = [&](int64_t cell, int number, bool is_pair) {
    return integrals_of(integrals, cell, number, is_pair);
  };
  const auto make = [&](int i, int64_t cell, int number, const ThreeIntegrals& loaded) {
    return combined.numbers[number * combined.cells + cell] = combine(loaded, weights[i]);
  };
  read_children(children, fine.octant, load, fetch_weights, make, read);
  sum_children(coarse, children, read, coarse_cells);
}
static_assert(kChildren == kThreads);

__global__ void down_sample_kernel(Topology fine, Topology coarse, CellSquares<float> fine_cells,
                                   CellSquares<float> coarse_cells) {
  __shared__ ChildNumbers read;
  let_next_start();
  const Children children = children_of_block(coarse);
  await_previous();
  const auto load = [&](int64_t cell, int number, bool) {
    return fine_cells.numbers[number * fine_cells.cells + cell];
  };
  const auto keep = [](int, int64_t, int, float loaded) { return loaded; };
  read_children(
      children, fine.octant, load, [] {}, keep, read);
  sum_children(coarse, children, read, coarse_cells);
}

__global__ void tell_alpha_kernel(UniformAlpha alpha, UniformAlpha* to) {
  await_previous();
  *to = alpha;
}

}  // namespace

void tell_alpha(Stream& stream, const UniformAlpha& alpha, UniformAlpha* to) {
  launch_blocks(stream, tell_alpha_kernel, dim3(1), dim3(1), 0, alpha, to);
}

void combine_integrals(Stream& stream, const Integrals& integrals, const Metric& metric,
                       const CellSquares<double>& combined) {
  launch(stream, combine_kernel, combined.cells, integrals, metric, combined);
}

void combine_integrals(Stream& stream, const Integrals& integrals, const SheetIntegrals& sheets,
                       const Metric& metric, const CellSquares<double>& combined,
                       const Topology& fine, const Topology& coarse,
                       const CellSquares<float>& coarse_cells) {
  launch(stream, combine_and_down_sample_kernel, 8 * coarse_cells.cells, integrals, metric,
         combined, fine, coarse, coarse_cells);
  launch(stream, combine_apart_kernel, int64_t{kWarps} * coarse.shares.apart_count, integrals,
         metric, combined, coarse.shares);
  launch(stream, combine_sheets_kernel, kWarps * sheets.integrals.cells, sheets, metric,
         combined.numbers + combined.kNumbers * combined.cells);
}

void down_sample(Stream& stream, const Topology& fine, const Topology& coarse,
                 const CellSquares<float>& fine_cells, const CellSquares<float>& coarse_cells) {
  launch(stream, down_sample_kernel, 8 * coarse_cells.cells, fine, coarse, fine_cells,
         coarse_cells);
  add_shares(stream, coarse.shares, fine_cells, coarse_cells);
}

}  // namespace burnish::cuda
