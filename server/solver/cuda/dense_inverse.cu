#include <utility>

#include "server/solver/cuda/dense_inverse.h"
#include "server/solver/cuda/kernel.h"

namespace burnish::cuda {

namespace {

constexpr double kRegularisation = 1e-5;
constexpr int kTile = 16;

/// Rows of the square, a whole number of tiles; those beyond the corners are the identity's.
int64_t padded(int64_t corner_count) {
  return (corner_count + kTile - 1) / kTile * kTile;
}

// From zero; n is padded.
__global__ void fill_kernel(int64_t n, Depth depth, double* square) {
  await_previous();
  const int64_t row = thread_index();
  if (row >= n) return;
  square[row * n + row] = 1 + kRegularisation;
  if (row >= depth.topology.corner_count) return;
  const Rows& rows = depth.topology.rows;
  const auto corner = static_cast<int32_t>(row);
  const double here = sqrt(static_cast<double>(depth.inverse_diagonal[row]));
  const int64_t begin = row_begin(rows, corner), end = row_end(rows, corner, begin);
  for (int64_t k = begin; k < end; k += kSliceRows) {
    const int32_t column = rows.column[k];
    square[row * n + column] =
        depth.system.entry[k] * here * sqrt(static_cast<double>(depth.inverse_diagonal[column]));
  }
}

// The tile's inverse, in place, by Gauss-Jordan without pivoting: the matrix is definite and, by
// the regularisation, its condition number is bounded.
__device__ void invert_tile(double (&tile)[kTile][kTile], int row, int column) {
  for (int pivot = 0; pivot < kTile; ++pivot) {
    const double inverse_pivot = 1 / tile[pivot][pivot];
    const double on_row = column == pivot ? inverse_pivot : tile[pivot][column] * inverse_pivot;
    const double factor = tile[row][pivot];
    const double kept = column == pivot ? 0 : tile[row][column];
    __syncthreads();
    tile[row][column] = row == pivot ? on_row : kept - factor * on_row;
    __syncthreads();
  }
}

// One step of Gauss-Jordan by tiles, one block per tile and one thread per number. With D the
// inverse of the pivot tile, row tiles become D A, column tiles −A D, and all others lose A D A.
__global__ void eliminate_kernel(int64_t n, int pivot, const double* from, double* to) {
  await_previous();
  __shared__ double inverse[kTile][kTile], on_row[kTile][kTile], on_column[kTile][kTile];
  const int row = static_cast<int>(threadIdx.y), column = static_cast<int>(threadIdx.x);
  const int tile_row = static_cast<int>(blockIdx.y), tile_column = static_cast<int>(blockIdx.x);
  const auto place = [&](int of_row, int of_column) {
    return (static_cast<int64_t>(of_row) * kTile + row) * n + of_column * kTile + column;
  };
  inverse[row][column] = from[place(pivot, pivot)];
  on_column[row][column] = from[place(tile_row, pivot)];
  // The pivot's own column of tiles counts as the identity, and so it is that D stays there.
  const double identity = row == column;
  const double there = tile_column == pivot ? identity : from[place(pivot, tile_column)];
  __syncthreads();
  invert_tile(inverse, row, column);
  double sum = 0;
  on_row[row][column] = there;
  __syncthreads();
  for (int k = 0; k < kTile; ++k) sum += inverse[row][k] * on_row[k][column];
  __syncthreads();
  on_row[row][column] = sum;
  __syncthreads();
  if (tile_row != pivot) {
    sum = tile_column == pivot ? 0 : from[place(tile_row, tile_column)];
    for (int k = 0; k < kTile; ++k) sum -= on_column[row][k] * on_row[k][column];
  }
  to[place(tile_row, tile_column)] = sum;
}

// One block per row.
__global__ void scale_kernel(int64_t n, Depth depth, const double* square, float* inverse) {
  await_previous();
  const int64_t row = blockIdx.x;
  const int32_t corners = depth.topology.corner_count;
  const double here = sqrt(static_cast<double>(depth.inverse_diagonal[row]));
  for (int column = static_cast<int>(threadIdx.x); column < corners; column += kThreads)
    inverse[row * corners + column] =
        static_cast<float>(square[row * n + column] * here *
                           sqrt(static_cast<double>(depth.inverse_diagonal[column])));
}

// One warp per row.
__global__ void multiply_kernel(Depth depth, const float* inverse) {
  await_previous();
  const int64_t row = thread_index() / 32;
  const int64_t n = depth.topology.corner_count;
  if (row >= n) return;
  const int lane = static_cast<int>(threadIdx.x % 32);
  float4 sum = zero4();
  for (int64_t column = lane; column < n; column += 32)
    sum = sum + inverse[row * n + column] * depth.f[column];
  for (int offset = 16; offset > 0; offset /= 2) {
    sum.x += __shfl_down_sync(0xffffffffu, sum.x, offset);
    sum.y += __shfl_down_sync(0xffffffffu, sum.y, offset);
    sum.z += __shfl_down_sync(0xffffffffu, sum.z, offset);
  }
  if (lane == 0) depth.x[row] = sum;
}

}  // namespace

DenseInverse::DenseInverse(Stream& stream, const Depth& depth) : depth_(depth) {
  const int64_t corners = depth.topology.corner_count, n = padded(corners);
  for (DeviceArray<double>& square : square_) square = {stream, static_cast<size_t>(n * n)};
  inverse_ = {stream, static_cast<size_t>(corners * corners)};
}

void DenseInverse::factor(Stream& stream) {
  const int64_t corners = depth_.topology.corner_count, n = padded(corners);
  const int tiles = static_cast<int>(n / kTile);
  if (!stream.is_ok()) return;
  square_[0].clear(stream);
  launch(stream, fill_kernel, n, n, depth_, square_[0].data());
  for (int pivot = 0; pivot < tiles; ++pivot)
    eliminate_kernel<<<dim3(tiles, tiles), dim3(kTile, kTile), 0, stream.get()>>>(
        n, pivot, square_[pivot % 2].data(), square_[(pivot + 1) % 2].data());
  launch(stream, scale_kernel, corners * kThreads, n, depth_, square_[tiles % 2].data(),
         inverse_.data());
}

void DenseInverse::solve(Stream& stream) const {
  launch(stream, multiply_kernel, 32 * static_cast<int64_t>(depth_.topology.corner_count), depth_,
         inverse_.data());
}

uint64_t DenseInverse::byte_count() const {
  return square_[0].byte_count() + square_[1].byte_count() + inverse_.byte_count();
}

}  // namespace burnish::cuda
