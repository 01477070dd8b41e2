#include "server/solver/cuda/constraint.h"
#include "server/solver/cuda/kernel.h"

namespace burnish::cuda {

namespace {

__device__ Double3 triple(const Gradients& gradients, int64_t cell, int first) {
  const float* g = gradients.numbers + first * gradients.cells + cell;
  return {g[0], g[gradients.cells], g[2 * gradients.cells]};
}

// One cell's share at its local corner a. The shares of a cell must add up to zero, since
// Σ_a ∇B_a = 0: a sum that is off by rounding would push the surface as a whole.
__device__ Double3 share_of(const Gradients& gradients, int64_t cell, int a, double weight1,
                            double weight2) {
  Double3 g1 = triple(gradients, cell, 6 * a), g2 = triple(gradients, cell, 6 * a + 3);
  if (a == 7) {
    g1 = g1 + triple(gradients, cell, 48);
    g2 = g2 + triple(gradients, cell, 51);
  }
  return weight1 * g1 + weight2 * g2;
}

// A cell that is not there counts as the first, times zero: its loads need not wait for a branch.
__global__ void constraint_kernel(Depth finest, Gradients gradients, FieldArrays fields, Double3* b,
                                  Double3* r) {
  let_next_start();
  const int64_t corner = thread_index();
  if (corner >= finest.topology.corner_count) return;
  const Eight cells = finest.topology.cells_of_corner[corner];
  await_previous();
  const bool is_free = finest.inverse_diagonal[corner] != 0;
  Double3 sum = {0, 0, 0};
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = is_free && cells.at[a] >= 0;
    const int32_t cell = is_there ? cells.at[a] : 0;
    const float change = is_there ? fields.beta[cell] - 1 : 0;
    const float ratio = fields.alpha2[cell] / fields.alpha1[cell];
    sum = sum + share_of(gradients, cell, a, change * ratio, change / ratio);
  }
  const Double3 residual = r[corner] + (sum - b[corner]);
  r[corner] = residual;
  finest.f[corner] = to_float(residual);
  b[corner] = sum;
}

}  // namespace

void assemble_constraint(Stream& stream, const Depth& finest, const Gradients& gradients,
                         const FieldArrays& fields, Double3* b, Double3* r) {
  launch(stream, constraint_kernel, finest.topology.corner_count, finest, gradients, fields, b, r);
}

}  // namespace burnish::cuda
