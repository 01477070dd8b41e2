#include "server/solver/cuda/assembly.h"
#include "server/solver/cuda/gather_rows.h"

namespace burnish::cuda {

namespace {

constexpr int kNumbers = 36;            // of a CellSquare
constexpr float kPinnedBelow = 1e-12f;  // of the median diagonal
constexpr int kMedianSamples = 1024;

// One thread per number of a cell.
__global__ void combine_kernel(int64_t count, const Integrals* integrals, const float* alpha1,
                               const float* alpha2, double scale, CellSquare<double>* combined) {
  const int64_t i = thread_index();
  if (i >= count) return;
  const int64_t c = i / kNumbers;
  const int number = static_cast<int>(i % kNumbers);
  const Integrals& in = integrals[c];
  const CombineWeights weights = combine_weights(alpha1[c] * scale, alpha2[c] * scale);
  if (number >= 28) {
    combined[c].own[number - 28] = weights.mass * in.mass_row_sum[number - 28];
  } else {
    combined[c].pair[number] =
        weights.mass * in.mass[number] + (weights.stiffness1 * in.stiffness[0][number] +
                                          weights.stiffness2 * in.stiffness[1][number]);
  }
}

// Numbers that are at least one compare as their bits do, and a largest has no order.
__global__ void anisotropy_kernel(int64_t count, const float* alpha1, const float* alpha2,
                                  float* anisotropy) {
  const int64_t c = thread_index();
  const float ratio = c < count ? alpha1[c] / alpha2[c] : 1;
  float most = fmaxf(ratio, 1 / ratio);
  for (int offset = 16; offset > 0; offset /= 2)
    most = fmaxf(most, __shfl_down_sync(0xffffffffu, most, offset));
  if (threadIdx.x % 32 == 0)
    atomicMax(reinterpret_cast<unsigned*>(anisotropy), __float_as_uint(most));
}

// P of a child cell: the weight of its corner a on the parent's corner A.
__device__ double child_weight(int octant, int a, int parent_corner) {
  double weight = 1;
#pragma unroll
  for (int axis = 0; axis < 3; ++axis) {
    const double high = 0.5 * ((octant >> axis & 1) + (a >> axis & 1));
    weight *= parent_corner >> axis & 1 ? high : 1 - high;
  }
  return weight;
}

// (Pᵀ K P)_AB for A ≠ B by pairs and row sums, which loses nothing:
// Σ_a m_a P_aA P_aB − Σ_a<b K_ab (P_aA − P_bA)(P_aB − P_bB).
__device__ double restricted_pair(const CellSquare<double>& child, int octant, int corner_a,
                                  int corner_b) {
  double on_a[8], on_b[8], sum = 0;
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    on_a[a] = child_weight(octant, a, corner_a);
    on_b[a] = child_weight(octant, a, corner_b);
    sum += child.own[a] * on_a[a] * on_b[a];
  }
#pragma unroll
  for (int a = 0; a < 8; ++a)
#pragma unroll
    for (int b = a + 1; b < 8; ++b)
      sum -= child.pair[pair_index(a, b)] * (on_a[a] - on_a[b]) * (on_b[a] - on_b[b]);
  return sum;
}

__device__ double restricted_row_sum(const CellSquare<double>& child, int octant, int corner) {
  double sum = 0;
#pragma unroll
  for (int a = 0; a < 8; ++a) sum += child.own[a] * child_weight(octant, a, corner);
  return sum;
}

__device__ void corners_of_pair(int pair, int& a, int& b) {
  for (a = 0; pair >= 7 - a; ++a) pair -= 7 - a;
  b = a + 1 + pair;
}

// One thread per number of a coarse cell.
__global__ void down_sample_kernel(int64_t count, Topology fine, Topology coarse,
                                   const CellSquare<double>* fine_cells,
                                   CellSquare<double>* coarse_cells) {
  const int64_t i = thread_index();
  if (i >= count) return;
  const int64_t parent = i / kNumbers;
  const int number = static_cast<int>(i % kNumbers);
  int corner_a = number - 28, corner_b = 0;
  if (number < 28) corners_of_pair(number, corner_a, corner_b);
  double sum = 0;
  for (int32_t k = coarse.child_start[parent]; k < coarse.child_start[parent + 1]; ++k) {
    const int32_t child = coarse.child[k];
    const int octant = fine.octant[child];
    sum += number < 28 ? restricted_pair(fine_cells[child], octant, corner_a, corner_b)
                       : restricted_row_sum(fine_cells[child], octant, corner_a);
  }
  if (number < 28)
    coarse_cells[parent].pair[number] = sum;
  else
    coarse_cells[parent].own[corner_a] = sum;
}

__global__ void assemble_kernel(const CellSquare<double>* cells, Depth depth, ExactMatrix exact) {
  const int64_t i = thread_index();
  if (i >= depth.topology.corner_count) return;
  const auto corner = static_cast<int32_t>(i);
  const GatheredRow<double> row = gather_row(depth.topology, cells, corner);
  double diagonal = row.own;
#pragma unroll
  for (int s = 0; s < kSlots; ++s) diagonal -= row.by_slot[s];
  depth.system.diagonal[corner] = static_cast<float>(diagonal);
  if (exact.row_sum != nullptr) exact.row_sum[corner] = row.own;
  for_present_slots(depth.topology.rows, corner, [&](int64_t k, int slot) {
    depth.system.entry[k] = static_cast<float>(row.by_slot[slot]);
    if (exact.entry != nullptr) exact.entry[k] = row.by_slot[slot];
  });
}

// The median of an even sample, by one block that sorts it (bitonic).
__global__ void pinned_below_kernel(int32_t n, const float* diagonal, float* pinned_below) {
  __shared__ float sample[kMedianSamples];
  const int stride = max(1, n / kMedianSamples);
  const int count = min(kMedianSamples, n / stride);
  const int t = static_cast<int>(threadIdx.x);
  sample[t] = t < count ? diagonal[t * stride] : __int_as_float(0x7f800000);  // infinity
  for (int size = 2; size <= kMedianSamples; size *= 2)
    for (int distance = size / 2; distance > 0; distance /= 2) {
      __syncthreads();
      const int other = t ^ distance;
      const bool swap = other > t && (sample[t] > sample[other]) == ((t & size) == 0);
      if (swap) {
        const float kept = sample[t];
        sample[t] = sample[other];
        sample[other] = kept;
      }
    }
  __syncthreads();
  if (t == 0) *pinned_below = kPinnedBelow * sample[count / 2];
}

__global__ void invert_diagonal_kernel(Depth depth, const float* pinned_below) {
  const int64_t i = thread_index();
  if (i >= depth.topology.corner_count) return;
  const float diagonal = depth.system.diagonal[i];
  depth.inverse_diagonal[i] = diagonal > *pinned_below ? 1 / diagonal : 0;
}

}  // namespace

void combine_integrals(Stream& stream, int32_t cell_count, const Integrals* integrals,
                       const float* alpha1, const float* alpha2, double scale,
                       CellSquare<double>* combined) {
  const int64_t count = static_cast<int64_t>(cell_count) * kNumbers;
  launch(stream, combine_kernel, count, count, integrals, alpha1, alpha2, scale, combined);
}

void find_anisotropy(Stream& stream, int32_t cell_count, const float* alpha1, const float* alpha2,
                     const DeviceArray<float>& anisotropy) {
  anisotropy.clear(stream);
  launch(stream, anisotropy_kernel, cell_count, cell_count, alpha1, alpha2, anisotropy.data());
}

void down_sample(Stream& stream, const Topology& fine, const Topology& coarse,
                 const CellSquare<double>* fine_cells, CellSquare<double>* coarse_cells) {
  const int64_t count = static_cast<int64_t>(coarse.cell_count) * kNumbers;
  launch(stream, down_sample_kernel, count, count, fine, coarse, fine_cells, coarse_cells);
}

void assemble(Stream& stream, const CellSquare<double>* cells, const Depth& depth,
              const ExactMatrix& exact, float* pinned_below) {
  const int32_t n = depth.topology.corner_count;
  launch(stream, assemble_kernel, n, cells, depth, exact);
  if (!stream.is_ok()) return;
  pinned_below_kernel<<<1, kMedianSamples, 0, stream.get()>>>(n, depth.system.diagonal,
                                                              pinned_below);
  launch(stream, invert_diagonal_kernel, n, depth, pinned_below);
}

}  // namespace burnish::cuda
