#include "server/solver/cuda/constraint.h"
#include "server/solver/cuda/kernel.h"
#include "server/solver/cuda/uniform.h"

namespace burnish::cuda {

namespace {

// A cell's shares must add up to zero, since Σ_a ∇B_a = 0: a sum that is off by rounding would push
// the surface as a whole. Hence what the last one's floats leave is kept too.
__global__ void combine_gradients_kernel(Gradients gradients, const float* ratio,
                                         CellGradients combined) {
  await_previous();
  const int64_t cell = thread_index();
  if (cell >= combined.cells) return;
  const float weight1 = ratio[cell], weight2 = 1 / weight1;
  const auto gradient = [&](int number) {
    return __ldg(gradients.numbers + number * gradients.cells + cell);
  };
  double last[3] = {};
#pragma unroll
  for (int a = 0; a < 7; ++a)
#pragma unroll
    for (int axis = 0; axis < 3; ++axis) {
      const float share = weight1 * gradient(6 * a + axis) + weight2 * gradient(6 * a + 3 + axis);
      combined.numbers[(3 * a + axis) * combined.cells + cell] = share;
      last[axis] -= share;
    }
#pragma unroll
  for (int axis = 0; axis < 3; ++axis) {
    const auto share = static_cast<float>(last[axis]);
    combined.numbers[(21 + axis) * combined.cells + cell] = share;
    combined.numbers[(24 + axis) * combined.cells + cell] = static_cast<float>(last[axis] - share);
  }
}

// Paint that is new, and the corners that it touches. Many threads mark a slice, all alike.
__global__ void take_paint_kernel(NewGradientScale beta, Topology finest, uint8_t* is_touched) {
  constexpr int kBlocks = kChunk / kThreads;  // of a chunk
  await_previous();
  const auto i = static_cast<int>(blockIdx.x / kBlocks);
  const int64_t chunk = beta.changed.is_all ? i : beta.changed.chunk[i];
  const int64_t cell = chunk * kChunk + blockIdx.x % kBlocks * kThreads + threadIdx.x;
  if (cell >= finest.cell_count) return;
  const Paint next = beta.from[cell], before = beta.paint[cell];
  if (next.follow == before.follow && next.own == before.own) return;
  beta.paint[cell] = next;
  const Eight corners = finest.cell_corners[cell];
#pragma unroll
  for (int a = 0; a < 8; ++a) is_touched[corners.at[a] / kSliceRows] = 1;
}

__device__ Double3 share_of(const CellGradients& combined, int64_t cell, int a) {
  const float* g = combined.numbers + cell;
  const auto triple = [&](int first) {
    return Double3{g[first * combined.cells], g[(first + 1) * combined.cells],
                   g[(first + 2) * combined.cells]};
  };
  return a == 7 ? triple(21) + triple(24) : triple(3 * a);
}

// The slices that are touched, or all after a new metric. A cell that is not there counts as the
// first, times zero: its loads need not wait for a branch.
template <bool kStale>
__global__ void gather_kernel(Depth finest, CellGradients combined, const Paint* paint,
                              double slider, Constraint b, Double3* r) {
  let_next_start();
  const int64_t count = finest.topology.corner_count;
  const int64_t corner = min(thread_index(), count - 1), slice = thread_index() / kSliceRows;
  if (slice * kSliceRows >= count) return;
  Eight cells;
  if (kStale) cells = finest.topology.cells_of_corner[corner];
  await_previous();
  if (thread_index() == 0) *b.slider_less_one = slider - 1;
  const bool is_touched = b.is_touched[slice] != 0, was_painted = b.is_painted[slice] != 0;
  if (!kStale && !is_touched) return;
  if (!kStale) cells = finest.topology.cells_of_corner[corner];
  const bool is_free = finest.inverse_diagonal[corner] != 0;
  Paint of[8];
  bool has_paint = false;
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    of[a] = is_touched || was_painted ? paint[max(cells.at[a], 0)] : kNoPaint;
    if (!is_free || cells.at[a] < 0) of[a] = {0, 0};
    has_paint |= is_free && cells.at[a] >= 0 && (of[a].follow != 1 || of[a].own != 0);
  }
  Double3 per_slider = {0, 0, 0}, own = {0, 0, 0};
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const Double3 share = share_of(combined, max(cells.at[a], 0), a);
    per_slider = per_slider + of[a].follow * share;
    own = own + of[a].own * share;
  }
  const bool is_painted = __any_sync(0xffffffffu, has_paint);  // and all have read the flags
  if (thread_index() % kSliceRows == 0) {
    b.is_touched[slice] = 0;
    b.is_painted[slice] = is_painted;
  }
  if (thread_index() >= count) return;
  if (!kStale) {
    Double3 change = (slider - 1) * (per_slider - b.per_slider[corner]) + own;
    if (was_painted) change = change - b.own[corner];
    const Double3 residual = r[corner] + change;
    r[corner] = residual;
    finest.f[corner] = to_float(residual);
  }
  b.per_slider[corner] = per_slider;
  if (is_painted) b.own[corner] = own;
}

// The slider from one place to another: r and f alone. Numbers one after the other, whichever
// corner's they are, so that threads side by side write side by side.
__global__ void slide_kernel(Depth finest, double before, double slider, Constraint b, Double3* r) {
  __shared__ float written[3 * kThreads];
  await_previous();
  if (thread_index() == 0) *b.slider_less_one = slider - 1;
  const double* per_slider = &b.per_slider->x;
  double* residual = &r->x;
  const int64_t all = int64_t{3} * finest.topology.corner_count;
#pragma unroll
  for (int j = 0; j < 3; ++j) {
    const auto at = static_cast<int>(threadIdx.x) + j * kThreads;
    const int64_t i = int64_t{3 * kThreads} * blockIdx.x + at;
    if (i >= all) break;
    const double number = residual[i] + (slider - before) * per_slider[i];
    residual[i] = number;
    written[at] = static_cast<float>(number);
  }
  __syncthreads();
  const float* of_corner = written + 3 * threadIdx.x;
  if (thread_index() < finest.topology.corner_count)
    finest.f[thread_index()] = {of_corner[0], of_corner[1], of_corner[2], 0};
}

}  // namespace

void combine_gradients(Stream& stream, const Gradients& gradients, const float* ratio,
                       const CellGradients& combined) {
  launch(stream, combine_gradients_kernel, combined.cells, gradients, ratio, combined);
}

void assemble_constraint(Stream& stream, const Depth& finest, const CellGradients& combined,
                         const NewGradientScale& beta, bool stale, const Constraint& b,
                         Double3* r) {
  const int64_t corners = finest.topology.corner_count;
  const bool is_painted = beta.changed.count > 0;
  launch(stream, take_paint_kernel, beta.changed.count * kChunk, beta, finest.topology,
         b.is_touched);
  if (!stale && beta.slider != beta.slider_before)
    launch(stream, slide_kernel, corners, finest, beta.slider_before, beta.slider, b, r);
  if (stale || is_painted)
    launch(stream, stale ? gather_kernel<true> : gather_kernel<false>, corners, finest, combined,
           beta.paint, beta.slider, b, r);
}

}  // namespace burnish::cuda
