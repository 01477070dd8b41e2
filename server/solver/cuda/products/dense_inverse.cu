#include <utility>

#include "server/solver/cuda/products/dense_inverse.h"
#include "server/solver/cuda/products/products.h"

namespace burnish::cuda {

namespace {

constexpr double kRegularisation = 1e-5;
constexpr int kSide = 32;

/// Returns the rows of the square, a whole number of tiles. The rows beyond the corners are the
/// identity's.
int64_t padded(int64_t corner_count) {
  return (corner_count + kSide - 1) / kSide * kSide;
}

// n is padded. Uses a warp for each row, a lane for each entry.
__global__ void fill_kernel(int64_t n, Depth depth, double* square) {
  await_previous();
  const Rows& rows = depth.topology.rows;
  const auto row = static_cast<int32_t>(thread_index() / 32),
             lane = static_cast<int32_t>(thread_index() % 32);
  if (row >= n) return;
  for (int64_t column = lane; column < n; column += 32)
    square[row * n + column] = column == row ? 1 + kRegularisation : 0;
  __syncwarp();
  if (row >= rows.count) return;
  const auto store = [&](int32_t column, float entry) {
    square[row * n + column] = entry * sqrt(static_cast<double>(depth.inverse_diagonal[row])) *
                               sqrt(static_cast<double>(depth.inverse_diagonal[column]));
  };
  if (lane < __popc(rows.mask[row])) {
    const int64_t k = row_begin(rows, row) + lane * kSliceRows;
    const uint32_t packed = depth.system.packed[k];
    store(column_of(group_of(rows, row / rows.group_rows), local_of(packed)),
          value_of(packed) + depth.system.rest[k]);
  }
  if (rows.long_rows.start == nullptr) return;
  for (int32_t k = rows.long_rows.start[row] + lane; k < rows.long_rows.start[row + 1]; k += 32)
    store(rows.long_rows.column[k], depth.system.long_entries[k]);
}

// A block does one tile. Each thread does kEach numbers of a column, kThreadRows rows apart: with
// one thread per number a step would fill the device and keep all other work from it.
constexpr int kThreadRows = 4;
constexpr int kEach = kSide / kThreadRows;
using Tile = double[kSide][kSide];

template <typename Visit>
__device__ void for_own_rows(Visit&& visit) {
#pragma unroll
  for (int j = 0; j < kEach; ++j) visit(j, static_cast<int>(threadIdx.y) + kThreadRows * j);
}

// Makes the tile's inverse in place, by Gauss-Jordan without pivoting, two pivots at a time. The
// matrix is definite, and the regularisation bounds its condition number.
__device__ void invert_tile(Tile& tile) {
  const auto column = static_cast<int>(threadIdx.x);
  for (int p = 0; p < kSide; p += 2) {
    const double a = tile[p][p], b = tile[p][p + 1], c = tile[p + 1][p], d = tile[p + 1][p + 1];
    const double scale = 1 / (a * d - b * c);
    const bool on_columns = column / 2 == p / 2;
    // The new values of the two pivot rows, above and below, in this column.
    const double above = on_columns ? double(column == p) : tile[p][column];
    const double below = on_columns ? double(column == p + 1) : tile[p + 1][column];
    const double new_above = scale * (d * above - b * below);
    const double new_below = scale * (a * below - c * above);
    double next[kEach];
    for_own_rows([&](int j, int row) {
      const double kept = on_columns ? 0 : tile[row][column];
      next[j] = kept - (tile[row][p] * new_above + tile[row][p + 1] * new_below);
      if (row / 2 == p / 2) next[j] = row == p ? new_above : new_below;
    });
    __syncthreads();
    for_own_rows([&](int j, int row) { tile[row][column] = next[j]; });
    __syncthreads();
  }
}

// Returns where a block's number of a tile stands.
__device__ int64_t place_in(int64_t n, int tile_row, int tile_column, int row) {
  return (static_cast<int64_t>(tile_row) * kSide + row) * n + tile_column * kSide + threadIdx.x;
}

__device__ void store_inverse(Tile& tile, const double (&value)[kEach], double* inverse) {
  const auto column = static_cast<int>(threadIdx.x);
  for_own_rows([&](int j, int row) { tile[row][column] = value[j]; });
  __syncthreads();
  invert_tile(tile);
  for_own_rows([&](int, int row) { inverse[row * kSide + column] = tile[row][column]; });
}

// Makes the inverse of the first pivot tile in one block.
__global__ void first_inverse_kernel(int64_t n, const double* square, double* inverse) {
  __shared__ Tile tile;
  await_previous();
  double value[kEach];
  for_own_rows([&](int j, int row) { value[j] = square[place_in(n, 0, 0, row)]; });
  store_inverse(tile, value, inverse);
}

// Does one step of Gauss-Jordan by tiles, one block per tile. D is the inverse of the pivot tile:
// row tiles become D A, column tiles −A D, and all others lose A D A. The block with the next pivot
// tile inverts it for the next step.
__global__ void eliminate_kernel(int64_t n, int pivot, const double* pivot_inverse,
                                 const double* from, double* to, double* next_inverse) {
  __shared__ Tile inverse, on_row, on_column;
  await_previous_alone();
  const auto column = static_cast<int>(threadIdx.x);
  const int tile_row = static_cast<int>(blockIdx.y), tile_column = static_cast<int>(blockIdx.x);
  double value[kEach];
  for_own_rows([&](int j, int row) {
    value[j] = from[place_in(n, tile_row, tile_column, row)];
    inverse[row][column] = pivot_inverse[row * kSide + column];
    on_column[row][column] = from[place_in(n, tile_row, pivot, row)];
    // The pivot's own column of tiles counts as the identity, so D stays there.
    on_row[row][column] =
        tile_column == pivot ? double(row == column) : from[place_in(n, pivot, tile_column, row)];
  });
  __syncthreads();
  double product[kEach] = {};
#pragma unroll
  for (int k = 0; k < kSide; ++k) {
    const double there = on_row[k][column];
    for_own_rows([&](int j, int row) { product[j] += inverse[row][k] * there; });
  }
  __syncthreads();
  for_own_rows([&](int j, int row) { on_row[row][column] = product[j]; });
  __syncthreads();
  if (tile_row == pivot) {
    for_own_rows([&](int j, int) { value[j] = product[j]; });
  } else {
    if (tile_column == pivot) for_own_rows([&](int j, int) { value[j] = 0; });
#pragma unroll
    for (int k = 0; k < kSide; ++k) {
      const double there = on_row[k][column];
      for_own_rows([&](int j, int row) { value[j] -= on_column[row][k] * there; });
    }
  }
  for_own_rows([&](int j, int row) { to[place_in(n, tile_row, tile_column, row)] = value[j]; });
  if (tile_row == pivot + 1 && tile_column == pivot + 1)
    store_inverse(inverse, value, next_inverse);
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

constexpr int kAhead = 5;  // numbers of a row per thread: all at most coarsest depths

// One block per row.
__global__ void multiply_kernel(Depth depth, const float* inverse) {
  __shared__ float4 of_warp[kThreads / 32];
  let_next_start();
  const int64_t n = depth.topology.corner_count, row = blockIdx.x;
  const int64_t t = threadIdx.x;
  float ahead[kAhead];
#pragma unroll
  for (int j = 0; j < kAhead; ++j)
    ahead[j] = t + j * kThreads < n ? inverse[row * n + t + j * kThreads] : 0;
  await_previous();
  float4 sum = zero4();
#pragma unroll
  for (int j = 0; j < kAhead; ++j)
    if (t + j * kThreads < n) sum = sum + ahead[j] * depth.f[t + j * kThreads];
  for (int64_t column = t + kAhead * kThreads; column < n; column += kThreads)
    sum = sum + inverse[row * n + column] * depth.f[column];
  for (int offset = 16; offset > 0; offset /= 2) {
    sum.x += __shfl_down_sync(0xffffffffu, sum.x, offset);
    sum.y += __shfl_down_sync(0xffffffffu, sum.y, offset);
    sum.z += __shfl_down_sync(0xffffffffu, sum.z, offset);
  }
  if (t % 32 == 0) of_warp[t / 32] = sum;
  __syncthreads();
  if (t != 0) return;
  for (int warp = 1; warp < kThreads / 32; ++warp) sum = sum + of_warp[warp];
  depth.x[row] = sum;
}

}  // namespace

DenseInverse::DenseInverse(Stream& stream, const Depth& depth) : depth_(depth) {
  const int64_t corners = depth.topology.corner_count, n = padded(corners);
  for (DeviceArray<double>& square : square_) square = {stream, static_cast<size_t>(n * n)};
  for (DeviceArray<double>& inverse : pivot_inverse_) inverse = {stream, kSide * kSide};
  inverse_ = {stream, static_cast<size_t>(corners * corners)};
}

void DenseInverse::factor(Stream& stream) {
  const int64_t corners = depth_.topology.corner_count, n = padded(corners);
  const int tiles = static_cast<int>(n / kSide);
  if (!stream.is_ok()) return;
  launch(stream, fill_kernel, 32 * n, n, depth_, square_[0].data());
  launch_blocks(stream, first_inverse_kernel, dim3(1), dim3(kSide, kThreadRows), 0, n,
                square_[0].data(), pivot_inverse_[0].data());
  for (int pivot = 0; pivot < tiles; ++pivot) {
    const int here = pivot % 2, there = 1 - here;
    launch_blocks(stream, eliminate_kernel, dim3(tiles, tiles), dim3(kSide, kThreadRows), 0, n,
                  pivot, pivot_inverse_[here].data(), square_[here].data(), square_[there].data(),
                  pivot_inverse_[there].data());
  }
  launch(stream, scale_kernel, corners * kThreads, n, depth_, square_[tiles % 2].data(),
         inverse_.data());
}

void DenseInverse::solve(Stream& stream) const {
  launch(stream, multiply_kernel, kThreads * static_cast<int64_t>(depth_.topology.corner_count),
         depth_, inverse_.data());
}

uint64_t DenseInverse::byte_count() const {
  return square_[0].byte_count() + square_[1].byte_count() + inverse_.byte_count();
}

}  // namespace burnish::cuda
