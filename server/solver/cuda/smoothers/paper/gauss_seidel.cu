#include "server/solver/cuda/device/kernel.h"
#include "server/solver/cuda/device/packed.h"
#include "server/solver/cuda/smoothers/paper/gauss_seidel.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cuda {

namespace {

constexpr int kSweeps = 2;

// The lowest Morton bits are the parities of i, j, k.
std::vector<int32_t> corners_by_colour(const SparseGrid& grid, std::span<int64_t> first_place) {
  std::array<std::vector<int32_t>, GaussSeidel::kColours> of_colour;
  for (int32_t i = 0; i < grid.corner_count(); ++i)
    of_colour[grid.corners[i].place & 7].push_back(i);
  std::vector<int32_t> corners;
  for (int colour = 0; colour < GaussSeidel::kColours; ++colour) {
    first_place[colour] = static_cast<int64_t>(corners.size());
    corners.insert(corners.end(), of_colour[colour].begin(), of_colour[colour].end());
    corners.resize((corners.size() + kSliceRows - 1) / kSliceRows * kSliceRows, -1);
  }
  first_place.back() = static_cast<int64_t>(corners.size());
  return corners;
}

std::vector<int64_t> slice_starts_of(const Stencil& stencil, std::span<const int32_t> corners) {
  std::vector<int64_t> starts = {0};
  for (size_t first = 0; first < corners.size(); first += kSliceRows) {
    int longest = 0;
    for (const int32_t i : corners.subspan(first, kSliceRows))
      if (i >= 0) longest = std::max(longest, __builtin_popcount(stencil.mask[i]));
    starts.push_back(starts.back() + longest * kSliceRows);
  }
  return starts;
}

std::vector<int32_t> columns_of(const Stencil& stencil, std::span<const int32_t> corners,
                                std::span<const int64_t> starts) {
  std::vector<int32_t> columns(starts.back(), -1);
#pragma omp parallel for schedule(static)
  for (size_t place = 0; place < corners.size(); ++place) {
    if (corners[place] < 0) continue;
    int64_t to = starts[place / kSliceRows] + static_cast<int64_t>(place) % kSliceRows;
    for (auto [k, end] = stencil.row(corners[place]); k < end; ++k, to += kSliceRows)
      columns[to] = stencil.column[k];
  }
  return columns;
}

// Copies only the packed entries, like the residual: a cycle with two matrices is not symmetric.
__global__ void copy_rows_kernel(Depth depth, GaussSeidel::Rows rows, int64_t places) {
  await_previous();
  const int64_t place = thread_index();
  const int32_t i = place < places ? rows.corner[place] : -1;
  if (i < 0) return;
  const int64_t from = row_begin(depth.topology.rows, i);
  const int64_t to = rows.slice_start[place / kSliceRows] + place % kSliceRows;
  const int count = __popc(depth.topology.rows.mask[i]);
  for (int64_t k = 0; k < kSliceRows * count; k += kSliceRows)
    rows.entry[to + k] = value_of(depth.system.packed[from + k]);
}

// Does x_I += D_I⁻¹ (f_I − Σ_J S_IJ x_J) at all corners of one colour.
__global__ void relax_kernel(Depth depth, GaussSeidel::Rows rows, int64_t first_place,
                             int64_t places) {
  let_next_start();
  const int64_t place = first_place + thread_index();
  const int32_t i = thread_index() < places ? rows.corner[place] : -1;
  if (i < 0) return;
  const int64_t begin = rows.slice_start[place / kSliceRows] + place % kSliceRows;
  const int64_t end = rows.slice_start[place / kSliceRows + 1];
  int32_t column[kEntriesMax];
  float entry[kEntriesMax];
#pragma unroll
  for (int j = 0; j < kEntriesMax; ++j) {
    const int64_t k = begin + kSliceRows * j;
    column[j] = k < end ? rows.column[k] : -1;
    entry[j] = k < end ? rows.entry[k] : 0;
  }
  const float diagonal = depth.system.diagonal[i], inverse = depth.inverse_diagonal[i];
  await_previous();
  const float4 x = depth.x[i];
  float4 product = diagonal * x;
#pragma unroll
  for (int j = 0; j < kEntriesMax; ++j)
    product = product + entry[j] * depth.x[column[j] >= 0 ? column[j] : i];
  depth.x[i] = x + inverse * (depth.f[i] - product);
}

}  // namespace

GaussSeidel::GaussSeidel(Stream& stream, const HierarchyDepth& topology, const Depth& depth)
    : stream_(stream), depth_(depth) {
  const std::vector<int32_t> corners = corners_by_colour(topology.grid, first_place_);
  const std::vector<int64_t> starts = slice_starts_of(topology.stencil, corners);
  corner_ = {stream, corners};
  slice_start_ = {stream, starts};
  column_ = {stream, columns_of(topology.stencil, corners, starts)};
  entry_ = {stream, static_cast<size_t>(starts.back())};
  rows_ = {corner_.data(), slice_start_.data(), column_.data(), entry_.data()};
}

Stream& GaussSeidel::fork() {
  branch_.fork();
  return branch_.stream();
}

void GaussSeidel::set_up(const CellSquares<float>&, const float*) {
  launch(branch_.stream(), copy_rows_kernel, first_place_.back(), depth_, rows_,
         first_place_.back());
}

void GaussSeidel::relax_from_zero() {
  if (stream_.is_ok())
    stream_.check(
        cudaMemsetAsync(depth_.x, 0, depth_.topology.corner_count * sizeof(float4), stream_.get()),
        "clearing x");
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int colour = 0; colour < kColours; ++colour) relax_colour(colour);
}

void GaussSeidel::relax() {
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (int colour = kColours - 1; colour >= 0; --colour) relax_colour(colour);
}

void GaussSeidel::relax_colour(int colour) {
  const int64_t places = first_place_[colour + 1] - first_place_[colour];
  launch(stream_, relax_kernel, places, depth_, rows_, first_place_[colour], places);
}

uint64_t GaussSeidel::byte_count() const {
  return corner_.byte_count() + column_.byte_count() + slice_start_.byte_count() +
         entry_.byte_count();
}

}  // namespace burnish::cuda
