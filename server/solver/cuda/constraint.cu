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
  beta.change[cell] = next - beta.now[cell];
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
                                  Double3* b, Double3* r) {
  let_next_start();
  const int64_t corner = thread_index();
  if (corner >= finest.topology.corner_count) return;
  const Eight cells = finest.topology.cells_of_corner[corner];
  await_previous();
  const bool is_free = finest.inverse_diagonal[corner] != 0;
  float distance[8], change[8];  // of β from 1 and from what it was
  bool is_changed = kStale;
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = is_free && cells.at[a] >= 0;
    distance[a] = is_there ? beta.now[cells.at[a]] - 1 : 0;
    change[a] = is_there ? beta.change[cells.at[a]] : 0;
    is_changed |= change[a] != 0;
  }
  if (!is_changed) return;
  Double3 sum = {0, 0, 0}, difference = {0, 0, 0};
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const Double3 share = share_of(combined, max(cells.at[a], 0), a);
    sum = sum + distance[a] * share;
    difference = difference + change[a] * share;
  }
  b[corner] = sum;
  if (kStale) return;
  const Double3 residual = r[corner] + difference;
  r[corner] = residual;
  finest.f[corner] = to_float(residual);
}

}  // namespace

void combine_gradients(Stream& stream, const Gradients& gradients, const float* ratio,
                       const CellGradients& combined) {
  launch(stream, combine_gradients_kernel, combined.cells, gradients, ratio, combined);
}

void assemble_constraint(Stream& stream, const Depth& finest, const CellGradients& combined,
                         const NewGradientScale& beta, bool stale, Double3* b, Double3* r) {
  launch(stream, take_kernel, combined.cells, beta, combined.cells);
  launch(stream, stale ? constraint_kernel<true> : constraint_kernel<false>,
         finest.topology.corner_count, finest, combined, beta, b, r);
}

}  // namespace burnish::cuda
