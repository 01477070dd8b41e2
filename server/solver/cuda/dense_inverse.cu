#include "server/solver/cuda/dense_inverse.h"

#include <utility>

#include "server/solver/cuda/kernel.h"

namespace burnish::cuda {

namespace {

constexpr double kRegularisation = 1e-5;

__global__ void fill_kernel(Depth depth, double* square) {
  const int64_t row = thread_index();
  const int64_t n = depth.topology.corner_count;
  if (row >= n) return;
  const Rows& rows = depth.topology.rows;
  const auto corner = static_cast<int32_t>(row);
  const double here = sqrt(static_cast<double>(depth.inverse_diagonal[row]));
  square[row * n + row] = 1 + kRegularisation;
  const int64_t begin = row_begin(rows, corner), end = row_end(rows, corner, begin);
  for (int64_t k = begin; k < end; k += kSliceRows) {
    const int32_t column = rows.column[k];
    square[row * n + column] =
        depth.system.entry[k] * here * sqrt(static_cast<double>(depth.inverse_diagonal[column]));
  }
}

// One step of Gauss-Jordan without pivoting, one thread per number: the matrix is definite and, by
// the regularisation, its condition number is bounded.
__global__ void eliminate_kernel(int64_t n, int64_t pivot, const double* from, double* to) {
  const int64_t i = thread_index();
  if (i >= n * n) return;
  const int64_t row = i / n, column = i % n;
  const double inverse_pivot = 1 / from[pivot * n + pivot];
  const double scaled = column == pivot ? inverse_pivot : from[pivot * n + column] * inverse_pivot;
  if (row == pivot)
    to[i] = scaled;
  else
    to[i] = (column == pivot ? 0 : from[i]) - from[row * n + pivot] * scaled;
}

__global__ void scale_kernel(Depth depth, const double* square, float* inverse) {
  const int64_t i = thread_index();
  const int64_t n = depth.topology.corner_count;
  if (i >= n * n) return;
  const double scale = sqrt(static_cast<double>(depth.inverse_diagonal[i / n]) *
                            static_cast<double>(depth.inverse_diagonal[i % n]));
  inverse[i] = static_cast<float>(square[i] * scale);
}

// One warp per row.
__global__ void multiply_kernel(Depth depth, const float* inverse) {
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
  const int64_t n = depth.topology.corner_count;
  for (DeviceArray<double>& square : square_) square = {stream, static_cast<size_t>(n * n)};
  inverse_ = {stream, static_cast<size_t>(n * n)};
}

void DenseInverse::factor(Stream& stream) {
  const int64_t n = depth_.topology.corner_count;
  square_[0].clear(stream);
  launch(stream, fill_kernel, n, depth_, square_[0].data());
  for (int64_t pivot = 0; pivot < n; ++pivot)
    launch(stream, eliminate_kernel, n * n, n, pivot, square_[pivot % 2].data(),
           square_[(pivot + 1) % 2].data());
  launch(stream, scale_kernel, n * n, depth_, square_[n % 2].data(), inverse_.data());
}

void DenseInverse::solve(Stream& stream) const {
  launch(stream, multiply_kernel, 32 * static_cast<int64_t>(depth_.topology.corner_count), depth_,
         inverse_.data());
}

uint64_t DenseInverse::byte_count() const {
  return square_[0].byte_count() + square_[1].byte_count() + inverse_.byte_count();
}

}  // namespace burnish::cuda
