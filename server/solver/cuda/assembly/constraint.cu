#include "server/solver/cuda/assembly/constraint.h"
#include "server/solver/cuda/assembly/gradient_shares.h"
#include "server/solver/cuda/device/chunks.h"
#include "server/solver/cuda/device/kernel.h"

namespace burnish::cuda {

namespace {

// Takes new paint and marks the corners that it touches. Many threads mark a slice, all with the
// same value.
__global__ void take_paint_kernel(NewGradientScale beta, Topology finest, uint8_t* is_touched) {
  await_previous();
  const auto place = static_cast<int32_t>(thread_index()), i = place / int32_t{kChunk};
  const int32_t chunk = beta.changed.is_all ? i : beta.changed.chunk[i];
  const int64_t cell = chunk * kChunk + place % kChunk;
  if (cell >= finest.cell_count) return;
  const Paint next = beta.from[place], before = beta.paint[cell];
  const Eight corners = finest.cell_corners[cell];
  if (next.follow == before.follow && next.own == before.own) return;
  beta.paint[cell] = next;
#pragma unroll
  for (int a = 0; a < 8; ++a) is_touched[corners.at[a] / kSliceRows] = 1;
}

__global__ void tell_slider_kernel(double less_one, double* to) {
  await_previous();
  *to = less_one;
}

// Gathers the touched slices. After new gradients it gathers all slices with paint; r must then be
// recomputed. Each slice takes a warp.
template <bool kRests>
__global__ void gather_painted_kernel(Depth finest, CellGradients combined, const Paint* paint,
                                      double slider_less_one, bool gradients_are_new, Constraint b,
                                      Double3* r) {
  await_previous();
  const int64_t i = thread_index(), slice = i / kSliceRows;
  const int64_t corner = min(i, int64_t{finest.topology.corner_count} - 1);
  if (slice > corner / kSliceRows) return;
  const bool is_touched = b.is_touched[slice] != 0, was_painted = b.is_painted[slice] != 0;
  if (!is_touched && !(gradients_are_new && was_painted)) return;
  const Eight cells = finest.topology.cells_of_corner[corner];
  bool has_paint = false;
  float follow[8], own[8];
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = cells.at[a] >= 0;
    const Paint of = paint[max(cells.at[a], 0)];
    follow[a] = is_there ? of.follow : 0;
    own[a] = is_there ? of.own : 0;
    has_paint |= is_there && (of.follow != 1 || of.own != 0);
  }
  double of_slider[3], of_paint[3];
#pragma unroll
  for (int axis = 0; axis < 3; ++axis) {
    const AxisShares shares = shares_of<kRests>(combined, cells, axis);
    of_slider[axis] = weighed(shares, follow);
    of_paint[axis] = weighed(shares, own);
  }
  const bool is_painted = __any_sync(0xffffffffu, has_paint);  // all have read the flags
  if (i % kSliceRows == 0) {
    b.is_touched[slice] = 0;
    b.is_painted[slice] = is_painted;
  }
  if (i > corner) return;
  const Double3 per_slider = {of_slider[0], of_slider[1], of_slider[2]};
  const Double3 own_part = {of_paint[0], of_paint[1], of_paint[2]};
  if (!gradients_are_new && finest.inverse_diagonal[corner] != 0) {
    Double3 change = slider_less_one * (per_slider - b.per_slider[corner]) + own_part;
    if (was_painted) change = change - b.own[corner];
    const Double3 residual = r[corner] + change;
    r[corner] = residual;
    finest.f[corner] = to_float(residual);
  }
  b.per_slider[corner] = per_slider;
  if (is_painted) b.own[corner] = own_part;
}

// Moves the slider: changes r and f only. Works on numbers in memory order, whichever corner they
// belong to, so that neighbouring threads write neighbouring numbers.
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
    const bool is_free = finest.inverse_diagonal[int64_t{kThreads} * blockIdx.x + at / 3] != 0;
    const double number = is_free ? residual[i] + (slider - before) * per_slider[i] : 0;
    residual[i] = number;
    written[at] = static_cast<float>(number);
  }
  __syncthreads();
  const float* of_corner = written + 3 * threadIdx.x;
  if (thread_index() < finest.topology.corner_count)
    finest.f[thread_index()] = {of_corner[0], of_corner[1], of_corner[2], 0};
}

}  // namespace

void assemble_constraint(Stream& stream, const Depth& finest, const CellGradients& combined,
                         const NewGradientScale& beta, bool gradients_are_new, const Constraint& b,
                         Double3* r) {
  const int64_t corners = finest.topology.corner_count;
  const double slider_less_one = beta.slider - 1;
  const bool rests = combined.rests != nullptr;
  launch(stream, take_paint_kernel, beta.changed.count * kChunk, beta, finest.topology,
         b.is_touched);
  if (gradients_are_new)
    launch_blocks(stream, tell_slider_kernel, dim3(1), dim3(1), 0, slider_less_one,
                  b.slider_less_one);
  else if (beta.slider != beta.slider_before)
    launch(stream, slide_kernel, corners, finest, beta.slider_before, beta.slider, b, r);
  if (beta.changed.count > 0 || (gradients_are_new && beta.is_painted))
    launch(stream, rests ? gather_painted_kernel<true> : gather_painted_kernel<false>, corners,
           finest, combined, beta.paint, slider_less_one, gradients_are_new, b, r);
}

}  // namespace burnish::cuda
