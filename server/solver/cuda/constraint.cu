#include "server/solver/cuda/constraint.h"
#include "server/solver/cuda/kernel.h"

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

__global__ void take_kernel(NewGradientScale beta, int64_t cells) {
  await_previous();
  const int64_t cell = thread_index();
  if (cell >= cells) return;
  const bool is_of_many = cell >= beta.begin && cell < beta.end;
  const float next = is_of_many ? beta.many[cell] : beta.one;
  beta.change[cell] = next - (beta.was_uniform ? beta.before : beta.now[cell]);
  beta.now[cell] = next;
}

__device__ Double3 share_of(const CellGradients& combined, int64_t cell, int a) {
  const float* g = combined.numbers + cell;
  const auto triple = [&](int first) {
    return Double3{g[first * combined.cells], g[(first + 1) * combined.cells],
                   g[(first + 2) * combined.cells]};
  };
  return a == 7 ? triple(21) + triple(24) : triple(3 * a);
}

// A cell that is not there counts as the first, times zero: its loads need not wait for a branch.
template <bool kStale>
__global__ void constraint_kernel(Depth finest, CellGradients combined, NewGradientScale beta,
                                  Constraint b, Double3* r) {
  let_next_start();
  const int64_t corner = thread_index();
  if (corner >= finest.topology.corner_count) return;
  const Eight cells = finest.topology.cells_of_corner[corner];
  await_previous();
  if (corner == 0) *b.scale = beta.is_uniform ? static_cast<double>(beta.one) - 1 : 1;
  const bool is_free = finest.inverse_diagonal[corner] != 0;
  float change[8];  // of β
  bool is_changed = kStale || beta.is_uniform || beta.was_uniform;
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = !kStale && is_free && cells.at[a] >= 0;
    change[a] = is_there ? beta.change[cells.at[a]] : 0;
    is_changed |= change[a] != 0;
  }
  if (!is_changed) return;
  float distance[8];  // of β from 1; 1 where all have the same β
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = is_free && cells.at[a] >= 0;
    distance[a] = is_there && !beta.is_uniform ? beta.now[cells.at[a]] - 1 : float(is_there);
  }
  Double3 sum = {0, 0, 0}, difference = {0, 0, 0};
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const Double3 share = share_of(combined, max(cells.at[a], 0), a);
    sum = sum + distance[a] * share;
    difference = difference + change[a] * share;
  }
  b.numbers[corner] = sum;
  if (kStale) return;
  const Double3 residual = r[corner] + difference;
  r[corner] = residual;
  finest.f[corner] = to_float(residual);
}

// All cells from one β to another: r and f alone. Numbers one after the other, whichever corner's
// they are, so that threads side by side write side by side.
__global__ void slide_kernel(Depth finest, NewGradientScale beta, Constraint b, Double3* r) {
  __shared__ float written[3 * kThreads];
  await_previous();
  if (thread_index() == 0) *b.scale = static_cast<double>(beta.one) - 1;
  const double change = static_cast<double>(beta.one) - static_cast<double>(beta.before);
  const double* per_change = &b.numbers->x;
  double* residual = &r->x;
  const int64_t all = int64_t{3} * finest.topology.corner_count;
#pragma unroll
  for (int j = 0; j < 3; ++j) {
    const auto at = static_cast<int>(threadIdx.x) + j * kThreads;
    const int64_t i = int64_t{3 * kThreads} * blockIdx.x + at;
    if (i >= all) break;
    const double number = residual[i] + change * per_change[i];
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
  if (beta.was_uniform && beta.is_uniform && !stale)
    return launch(stream, slide_kernel, corners, finest, beta, b, r);
  if (!beta.is_uniform || !stale) launch(stream, take_kernel, combined.cells, beta, combined.cells);
  launch(stream, stale ? constraint_kernel<true> : constraint_kernel<false>, corners, finest,
         combined, beta, b, r);
}

}  // namespace burnish::cuda
