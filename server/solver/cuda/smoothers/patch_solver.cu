#include <algorithm>

#include "server/solver/cuda/products/products.h"
#include "server/solver/cuda/smoothers/patch_solver.h"

namespace burnish::cuda {

namespace {

constexpr double kRegularisation = 1e-6;  // cpu/smoothers/patch_solver.cpp says why
constexpr int kWarps = kThreads / 32;
static_assert(kPatchCornersMax <= kThreads, "a thread for each corner");

struct Patch {
  int count;
  const int32_t* corner;
  int64_t first_entry;
};

__device__ Patch patch_at(const PatchList& list, int32_t p) {
  return {list.start[p + 1] - list.start[p], list.corner + list.start[p], list.entry_start[p]};
}

/// Returns where row i of a lower triangle begins.
__host__ __device__ constexpr int row_of_triangle(int i) {
  return i * (i + 1) / 2;
}

/// Visits (column, entry) of a row of S, with all stored digits.
template <typename Visit>
__device__ void visit_row(const Depth& depth, int32_t corner, int first, int step, Visit&& visit) {
  const Rows& rows = depth.topology.rows;
  const Group group = group_of(rows, corner / rows.group_rows);
  const int64_t begin = row_begin(rows, corner);
  for (int k = first; k < __popc(rows.mask[corner]); k += step) {
    const int64_t at = begin + kSliceRows * k;
    const uint32_t packed = depth.system.packed[at];
    visit(column_of(group, local_of(packed)), value_of(packed) + depth.system.rest[at]);
  }
}

/// The shared data of a patch's threads beside its triangle.
struct FactorRoom {
  int32_t corner[kPatchCornersMax];
  float scale[kPatchCornersMax];
  double column[kPatchCornersMax];
};

__device__ int place_of(int32_t corner, const int32_t* corners, int count) {
  int begin = 0, end = count;
  while (begin < end) {
    const int middle = (begin + end) / 2;
    corners[middle] < corner ? begin = middle + 1 : end = middle;
  }
  return begin < count && corners[begin] == corner ? begin : -1;
}

// Fills the lower triangle of the scaled, regularised block: a warp for each row.
__device__ void fill(const Depth& depth, const Patch& patch, FactorRoom& room, double* triangle) {
  const auto t = static_cast<int>(threadIdx.x), warp = t / 32, lane = t % 32;
  if (t < patch.count) {
    room.corner[t] = patch.corner[t];
    room.scale[t] = sqrtf(depth.inverse_diagonal[patch.corner[t]]);
  }
  for (int k = t; k < row_of_triangle(patch.count); k += kThreads) triangle[k] = 0;
  __syncthreads();
  for (int i = warp; i < patch.count; i += kWarps) {
    if (lane == 0) triangle[row_of_triangle(i) + i] = 1 + kRegularisation;
    visit_row(depth, room.corner[i], lane, 32, [&](int32_t column, float entry) {
      const int j = place_of(column, room.corner, patch.count);
      if (j >= 0 && j < i)
        triangle[row_of_triangle(i) + j] =
            static_cast<double>(entry) * room.scale[i] * room.scale[j];
    });
  }
  __syncthreads();
}

// Makes Cholesky's factor in place, column by column. The regularisation keeps pivots above itself,
// except for rounding.
__device__ void factor_in_place(int count, FactorRoom& room, double* triangle) {
  const auto t = static_cast<int>(threadIdx.x), warp = t / 32, lane = t % 32;
  for (int p = 0; p < count; ++p) {
    const double pivot = sqrt(fmax(triangle[row_of_triangle(p) + p], kRegularisation));
    if (t >= p && t < count) room.column[t] = triangle[row_of_triangle(t) + p] / pivot;
    __syncthreads();
    if (t >= p && t < count) triangle[row_of_triangle(t) + p] = t == p ? pivot : room.column[t];
    for (int i = p + 1 + warp; i < count; i += kWarps)
      for (int j = p + 1 + lane; j <= i; j += 32)
        triangle[row_of_triangle(i) + j] -= room.column[i] * room.column[j];
    __syncthreads();
  }
}

// Makes the factor's inverse in place, row by row, a thread for each column: W_ij = −Σ_k L_ik W_kj
// / L_ii.
__device__ void invert_in_place(int count, double* triangle) {
  const auto j = static_cast<int>(threadIdx.x);
  for (int i = 0; i < count; ++i) {
    const double* row = triangle + row_of_triangle(i);
    double sum = j == i ? -1 : 0;
    for (int k = j; k < i; ++k) sum += row[k] * triangle[row_of_triangle(k) + j];
    const double entry = -sum / row[i];
    __syncthreads();
    if (j <= i) triangle[row_of_triangle(i) + j] = entry;
    __syncthreads();
  }
}

__device__ bool is_touched(const Depth& depth, const Patch& patch, const BlockList& rows) {
  if (rows.lists == nullptr) return true;
  const auto t = static_cast<int>(threadIdx.x);
  const bool mine =
      t < patch.count && is_listed(rows, patch.corner[t] / depth.topology.rows.group_rows);
  return __syncthreads_or(mine) != 0;
}

__global__ void factor_kernel(Depth depth, PatchList list, float* factor_inverse, BlockList rows) {
  extern __shared__ double triangle[];
  __shared__ FactorRoom room;
  await_previous();
  const Patch patch = patch_at(list, static_cast<int32_t>(blockIdx.x));
  if (!is_touched(depth, patch, rows)) return;
  fill(depth, patch, room, triangle);
  factor_in_place(patch.count, room, triangle);
  invert_in_place(patch.count, triangle);
  const auto j = static_cast<int>(threadIdx.x);
  for (int i = j; i < patch.count; ++i)
    factor_inverse[patch.first_entry + row_of_triangle(i) + j] =
        static_cast<float>(triangle[row_of_triangle(i) + j] * room.scale[j]);
}

// Several threads of a block share each corner. A single thread would wait for its loads one after
// the other, and colours also come one after the other.
constexpr int kQuarters = 4;
constexpr int kRelaxThreads = kQuarters * kThreads;

// Returns one quarter's part of S x at a corner.
__device__ float4 part_of_product(const Depth& depth, int32_t corner, int quarter) {
  float4 product = quarter == 0 ? depth.system.diagonal[corner] * depth.x[corner] : zero4();
  visit_row(depth, corner, quarter, kQuarters,
            [&](int32_t column, float entry) { product = product + entry * depth.x[column]; });
  return product;
}

__device__ float4 sum_of_warp(float4 value) {
  for (int offset = 16; offset > 0; offset /= 2) {
    value.x += __shfl_xor_sync(0xffffffffu, value.x, offset);
    value.y += __shfl_xor_sync(0xffffffffu, value.y, offset);
    value.z += __shfl_xor_sync(0xffffffffu, value.z, offset);
  }
  return value;
}

__device__ float4 sum_of_quarters(const float4 (&part)[kQuarters][kThreads], int t) {
  return (part[0][t] + part[1][t]) + (part[2][t] + part[3][t]);
}

// Does x += WᵀW (f − S x) at the patch's corners: W by a warp for each row, Wᵀ by quarters of rows
// for each column.
__global__ void __launch_bounds__(kRelaxThreads)
    relax_kernel(Depth depth, PatchList list, int32_t first, const float* entries) {
  __shared__ float4 part[kQuarters][kThreads], residual[kThreads], middle[kThreads];
  let_next_start();
  const Patch patch = patch_at(list, first + static_cast<int32_t>(blockIdx.x));
  const float* w = entries + patch.first_entry;
  const auto thread = static_cast<int>(threadIdx.x), warp = thread / 32, lane = thread % 32;
  const int t = thread % kThreads, quarter = thread / kThreads;
  const int32_t corner = t < patch.count ? patch.corner[t] : -1;
  const bool is_free = corner >= 0 && depth.inverse_diagonal[corner] != 0;
  await_previous();
  if (is_free) part[quarter][t] = part_of_product(depth, corner, quarter);
  __syncthreads();
  if (quarter == 0)
    residual[t] = is_free ? depth.f[corner] + -1 * sum_of_quarters(part, t) : zero4();
  __syncthreads();
  for (int i = warp; i < patch.count; i += kRelaxThreads / 32) {
    float4 sum = zero4();
    for (int j = lane; j <= i; j += 32) sum = sum + w[row_of_triangle(i) + j] * residual[j];
    sum = sum_of_warp(sum);
    if (lane == 0) middle[i] = sum;
  }
  __syncthreads();
  float4 sum = zero4();
#pragma unroll 4
  for (int i = quarter; i < patch.count; i += kQuarters)
    if (i >= t) sum = sum + w[row_of_triangle(i) + t] * middle[i];
  part[quarter][t] = sum;
  __syncthreads();
  if (quarter == 0 && corner >= 0) depth.x[corner] = depth.x[corner] + sum_of_quarters(part, t);
}

int largest_patch(const Patches& patches) {
  int largest = 0;
  for (int32_t p = 0; p < patches.count(); ++p)
    largest = std::max(largest, patches.start[p + 1] - patches.start[p]);
  return largest;
}

}  // namespace

PatchSolver::PatchSolver(Stream& stream, const Depth& depth, const Patches& patches,
                         const PatchList& list)
    : stream_(stream),
      depth_(depth),
      patches_(patches),
      list_(list),
      factor_inverse_(stream, patches.entry_count()),
      shared_bytes_(row_of_triangle(largest_patch(patches)) * sizeof(double)) {
  if (patches.count() > 0)
    stream.check(cudaFuncSetAttribute(factor_kernel, cudaFuncAttributeMaxDynamicSharedMemorySize,
                                      row_of_triangle(kPatchCornersMax) * int{sizeof(double)}),
                 "making room for patches");
}

void PatchSolver::factor(Stream& stream, const BlockList& rows) {
  if (patches_.count() > 0)
    launch_blocks(stream, factor_kernel, dim3(patches_.count()), dim3(kThreads), shared_bytes_,
                  depth_, list_, factor_inverse_.data(), rows);
}

void PatchSolver::relax_colour(int32_t colour) {
  const int32_t first = patches_.colour_start[colour];
  launch_blocks(stream_, relax_kernel, dim3(patches_.colour_start[colour + 1] - first),
                dim3(kRelaxThreads), 0, depth_, list_, first, factor_inverse_.data());
}

void PatchSolver::relax_forwards() {
  for (int32_t colour = 0; colour < patches_.colour_count(); ++colour) relax_colour(colour);
}

void PatchSolver::relax_backwards() {
  for (int32_t colour = patches_.colour_count(); colour-- > 0;) relax_colour(colour);
}

}  // namespace burnish::cuda
