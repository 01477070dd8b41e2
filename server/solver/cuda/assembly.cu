#include "server/solver/cuda/assembly.h"
#include "server/solver/cuda/gather_rows.h"
#include "server/solver/cuda/products.h"

namespace burnish::cuda {

namespace {

constexpr float kPinnedBelow = 1e-12f;  // of the median diagonal
constexpr int kMedianSamples = 256;

// Numbers that are at least one compare as their bits do, and a largest has no order.
__device__ void keep_largest(float number, float* largest) {
  for (int offset = 16; offset > 0; offset /= 2)
    number = fmaxf(number, __shfl_xor_sync(0xffffffffu, number, offset));
  if (threadIdx.x % 32 == 0)
    atomicMax(reinterpret_cast<unsigned*>(largest), __float_as_uint(number));
}

__global__ void combine_kernel(Integrals integrals, const float* alpha1, const float* alpha2,
                               double scale, CellSquares<double> combined, float* anisotropy) {
  await_previous();
  const bool is_there = thread_index() < combined.cells;
  const int64_t cell = is_there ? thread_index() : 0;
  const float a1 = alpha1[cell], a2 = alpha2[cell];
  keep_largest(fmaxf(a1 / a2, a2 / a1), anisotropy);
  if (!is_there) return;
  const CombineWeights weights = combine_weights(a1 * scale, a2 * scale);
  const auto integral = [&](int number) {
    return integrals.numbers[number * integrals.cells + cell];
  };
#pragma unroll 7
  for (int pair = 0; pair < 28; ++pair)
    pair_of(combined, cell, pair) =
        weights.mass * integral(pair) +
        (weights.stiffness1 * integral(36 + pair) + weights.stiffness2 * integral(64 + pair));
#pragma unroll
  for (int a = 0; a < 8; ++a) own_of(combined, cell, a) = weights.mass * integral(28 + a);
}

// The combined integrals of a block's children, each read once.
constexpr int kParents = kThreads / 8;
constexpr int kChildren = 8 * kParents;
struct Children {
  int octant[kChildren];
  double numbers[CellSquares<double>::kNumbers][kChildren + 1];  // one more: banks
};

__device__ void read_children(const CellSquares<double>& cells, const uint8_t* octant,
                              const int32_t* child, int count, Children& children) {
  constexpr int kWarps = kThreads / 32;
  for (int i = static_cast<int>(threadIdx.x); i < count; i += kThreads)
    children.octant[i] = octant[child[i]];
  for (int i = static_cast<int>(threadIdx.x % 32); i < count; i += 32) {
    const double* numbers = cells.numbers + child[i];
#pragma unroll
    for (int n = 0; n < CellSquares<double>::kNumbers / kWarps; ++n) {
      const int number = n * kWarps + static_cast<int>(threadIdx.x / 32);
      children.numbers[number][i] = numbers[number * cells.cells];
    }
  }
  __syncthreads();
}

// Row a of K; its last number is the row sum.
__device__ void read_row(const Children& children, int i, int a, double (&row)[9]) {
  row[8] = children.numbers[28 + a][i];
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

// K P within a row. Along each axis the child's corner in the parent's middle shares itself out by
// halves.
__device__ void restrict_columns(int octant, double (&row)[9]) {
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

// Pᵀ from the left, among the eight neighbouring threads that hold a row each.
__device__ void restrict_rows(int octant, int a, unsigned group, double (&row)[9]) {
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

// Eight threads per coarse cell, each with a row.
__global__ void down_sample_kernel(Topology fine, Topology coarse, CellSquares<double> fine_cells,
                                   CellSquares<double> coarse_cells) {
  __shared__ Children children;
  let_next_start();
  const int64_t first_parent = static_cast<int64_t>(blockIdx.x) * kParents;
  const int64_t parents_end = min(first_parent + kParents, coarse_cells.cells);
  const int32_t first = coarse.child_start[first_parent], end = coarse.child_start[parents_end];
  await_previous();
  read_children(fine_cells, fine.octant, coarse.child + first, end - first, children);
  const int64_t parent = thread_index() / 8;
  if (parent >= coarse_cells.cells) return;
  const int a = static_cast<int>(threadIdx.x % 8);
  const unsigned group = 0xffu << (threadIdx.x % 32 / 8 * 8);
  double sum[9] = {};
  for (int32_t k = coarse.child_start[parent]; k < coarse.child_start[parent + 1]; ++k) {
    const int octant = children.octant[k - first];
    double row[9];
    read_row(children, k - first, a, row);
    restrict_columns(octant, row);
    restrict_rows(octant, a, group, row);
#pragma unroll
    for (int b = 0; b < 9; ++b) sum[b] += row[b];
  }
#pragma unroll
  for (int b = 0; b < 8; ++b)
    if (b > a) pair_of(coarse_cells, parent, pair_index(a, b)) = sum[b];
  own_of(coarse_cells, parent, a) = sum[8];
}

__global__ void assemble_kernel(CellSquares<double> cells, Depth depth, double* row_sum) {
  await_previous();
  const int32_t corner = row_of(group_of(depth.topology.rows, blockIdx.x));
  if (corner < 0) return;
  const GatheredRow<double> row = gather_row(depth.topology, cells, corner);
  double diagonal = row.own;
#pragma unroll
  for (int s = 0; s < kSlots; ++s) diagonal -= row.by_slot[s];
  depth.system.diagonal[corner] = static_cast<float>(diagonal);
  if (row_sum != nullptr) row_sum[corner] = row.own;
  store_row(depth.topology.rows, corner, row, [&](int64_t k, double value, uint32_t local) {
    const uint32_t packed = pack(static_cast<float>(value), local);
    depth.system.packed[k] = packed;
    depth.rest[k] = static_cast<float>(value - value_of(packed));
  });
}

// The median of an even sample, by one block: the number that half of the others precede.
__global__ void pinned_below_kernel(int32_t n, const float* diagonal, float* pinned_below) {
  __shared__ float4 sample[kMedianSamples / 4];
  await_previous();
  const int stride = max(1, n / kMedianSamples);
  const int count = min(kMedianSamples, n / stride);
  const int t = static_cast<int>(threadIdx.x);
  const float mine = t < count ? diagonal[t * stride] : __int_as_float(0x7f800000);  // infinity
  reinterpret_cast<float*>(sample)[t] = mine;
  __syncthreads();
  const auto precedes = [&](float other, int index) {
    return static_cast<int>(other < mine) |
           (static_cast<int>(other == mine) & static_cast<int>(index < t));
  };
  int rank = 0;
#pragma unroll 4
  for (int k = 0; k < kMedianSamples / 4; ++k) {
    const float4 others = sample[k];
    rank += precedes(others.x, 4 * k) + precedes(others.y, 4 * k + 1) +
            precedes(others.z, 4 * k + 2) + precedes(others.w, 4 * k + 3);
  }
  if (rank == count / 2) *pinned_below = kPinnedBelow * mine;
}

__global__ void invert_diagonal_kernel(Depth depth, const float* pinned_below) {
  await_previous();
  const int64_t i = thread_index();
  if (i >= depth.topology.corner_count) return;
  const float diagonal = depth.system.diagonal[i];
  depth.inverse_diagonal[i] = diagonal > *pinned_below ? 1 / diagonal : 0;
}

}  // namespace

void combine_integrals(Stream& stream, const Integrals& integrals, const float* alpha1,
                       const float* alpha2, double scale, const CellSquares<double>& combined,
                       const DeviceArray<float>& anisotropy) {
  anisotropy.clear(stream);
  launch(stream, combine_kernel, combined.cells, integrals, alpha1, alpha2, scale, combined,
         anisotropy.data());
}

void down_sample(Stream& stream, const Topology& fine, const Topology& coarse,
                 const CellSquares<double>& fine_cells, const CellSquares<double>& coarse_cells) {
  launch(stream, down_sample_kernel, 8 * coarse_cells.cells, fine, coarse, fine_cells,
         coarse_cells);
}

void assemble(Stream& stream, const CellSquares<double>& cells, const Depth& depth, double* row_sum,
              float* pinned_below) {
  const int32_t n = depth.topology.corner_count;
  launch_groups(stream, assemble_kernel, depth.topology.rows, cells, depth, row_sum);
  launch_blocks(stream, pinned_below_kernel, dim3(1), dim3(kMedianSamples), 0, n,
                depth.system.diagonal, pinned_below);
  launch(stream, invert_diagonal_kernel, n, depth, pinned_below);
}

}  // namespace burnish::cuda
