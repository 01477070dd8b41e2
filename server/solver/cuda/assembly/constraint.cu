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

// The change of b per slider step at a corner, and what does not follow the slider.
struct CornerSums {
  double of_slider[3] = {}, own[3] = {};
};

// The weights of a corner's cells, 0 where there is no cell.
struct CellWeights {
  float follow[8], own[8];
};

template <bool kRests>
__device__ CornerSums sum_painted(const CellGradients& combined, const Eight& cells,
                                  const CellWeights& weights) {
  CornerSums sums;
#pragma unroll
  for (int axis = 0; axis < 3; ++axis) {
    const AxisShares shares = shares_of<kRests>(combined, cells, axis);
    sums.of_slider[axis] = weighed(shares, weights.follow);
    sums.own[axis] = weighed(shares, weights.own);
  }
  return sums;
}

// Adds the share `g` of a cell with a target.
__device__ void add_led(const TargetMatrices& cell, double strength, const double (&g)[3],
                        float follow, float own, CornerSums& sums) {
#pragma unroll
  for (int row = 0; row < 3; ++row) {
    double of_scale = 0, of_target = 0;
#pragma unroll
    for (int i = 0; i < 3; ++i) {
      of_scale += cell.of_scale[3 * row + i] * g[i];
      of_target += cell.of_target[3 * row + i] * g[i];
    }
    const double scaled = g[row] + strength * of_scale;
    sums.of_slider[row] += follow * scaled;
    sums.own[row] += strength * of_target;
    sums.own[row] += own * scaled;
  }
}

template <bool kRests>
__device__ CornerSums sum_led(const CellGradients& combined, const Eight& cells,
                              const CellWeights& weights, const NewTarget& target) {
  const AxisShares<kRests> shares[3] = {shares_of<kRests>(combined, cells, 0),
                                        shares_of<kRests>(combined, cells, 1),
                                        shares_of<kRests>(combined, cells, 2)};
  CornerSums sums;
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    if (cells.at[a] < 0) continue;
    double g[3];
#pragma unroll
    for (int axis = 0; axis < 3; ++axis) {
      g[axis] = shares[axis].at[a];
      if (a == 7) g[axis] += shares[axis].rest;
    }
    const double strength = target.strength * (target.part ? target.part[cells.at[a]] : 1);
    add_led(target.cells[cells.at[a]], strength, g, weights.follow[a], weights.own[a], sums);
  }
  return sums;
}

// Gathers the touched slices, or all if the target is new. After new gradients it gathers all
// slices with paint; r must then be recomputed. Each slice takes a warp.
template <bool kRests, bool kIsLed>
__global__ void gather_painted_kernel(Depth finest, CellGradients combined, const Paint* paint,
                                      NewTarget target, double slider_less_one,
                                      bool gradients_are_new, Constraint b, Double3* r) {
  await_previous();
  const int64_t i = thread_index(), slice = i / kSliceRows;
  const int64_t corner = min(i, int64_t{finest.topology.corner_count} - 1);
  if (slice > corner / kSliceRows) return;
  const bool is_touched = b.is_touched[slice] != 0, was_painted = b.is_painted[slice] != 0;
  if (!is_touched && !target.is_new && !(gradients_are_new && was_painted)) return;
  const Eight cells = finest.topology.cells_of_corner[corner];
  bool has_paint = kIsLed;
  CellWeights weights;
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = cells.at[a] >= 0;
    const Paint of = paint[max(cells.at[a], 0)];
    weights.follow[a] = is_there ? of.follow : 0;
    weights.own[a] = is_there ? of.own : 0;
    has_paint |= is_there && (of.follow != 1 || of.own != 0);
  }
  CornerSums sums;
  if constexpr (kIsLed)
    sums = sum_led<kRests>(combined, cells, weights, target);
  else
    sums = sum_painted<kRests>(combined, cells, weights);
  const bool is_painted = __any_sync(0xffffffffu, has_paint);  // all have read the flags
  if (i % kSliceRows == 0) {
    b.is_touched[slice] = 0;
    b.is_painted[slice] = is_painted;
  }
  if (i > corner) return;
  const Double3 per_slider = {sums.of_slider[0], sums.of_slider[1], sums.of_slider[2]};
  const Double3 own_part = {sums.own[0], sums.own[1], sums.own[2]};
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

auto choose_gather(bool rests, bool is_led) {
  if (is_led) return rests ? gather_painted_kernel<true, true> : gather_painted_kernel<false, true>;
  return rests ? gather_painted_kernel<true, false> : gather_painted_kernel<false, false>;
}

}  // namespace

void assemble_constraint(Stream& stream, const Depth& finest, const CellGradients& combined,
                         const NewGradientScale& beta, const NewTarget& target,
                         bool gradients_are_new, const Constraint& b, Double3* r) {
  const int64_t corners = finest.topology.corner_count;
  const double slider_less_one = beta.slider - 1;
  const bool rests = combined.rests != nullptr, is_led = target.cells != nullptr;
  launch(stream, take_paint_kernel, beta.changed.count * kChunk, beta, finest.topology,
         b.is_touched);
  if (gradients_are_new)
    launch_blocks(stream, tell_slider_kernel, dim3(1), dim3(1), 0, slider_less_one,
                  b.slider_less_one);
  else if (beta.slider != beta.slider_before)
    launch(stream, slide_kernel, corners, finest, beta.slider_before, beta.slider, b, r);
  if (beta.changed.count > 0 || target.is_new || (gradients_are_new && (beta.is_painted || is_led)))
    launch(stream, choose_gather(rests, is_led), corners, finest, combined, beta.paint, target,
           slider_less_one, gradients_are_new, b, r);
}

}  // namespace burnish::cuda
