#include "server/solver/cuda/constraint.h"
#include "server/solver/cuda/kernel.h"

namespace burnish::cuda {

namespace {

// g of local corner a; the last is minus the sum of the others, since Σ_a ∇B_a = 0.
__device__ Double3 gradient_of(const double* gradient, int a) {
  const auto read = [&](int i) {
    return Double3{gradient[3 * i], gradient[3 * i + 1], gradient[3 * i + 2], 0};
  };
  if (a < 7) return read(a);
  Double3 g = {0, 0, 0, 0};
  for (int other = 0; other < 7; ++other) g = g - read(other);
  return g;
}

__global__ void constraint_kernel(Depth finest, const Integrals* integrals, FieldArrays fields,
                                  Double3* b, Double3* r) {
  const int64_t corner = thread_index();
  if (corner >= finest.topology.corner_count) return;
  Double3 sum = {0, 0, 0, 0};
  for (int a = 0; a < 8; ++a) {
    const int32_t cell = finest.topology.cells_of_corner[corner].at[a];
    if (cell < 0 || fields.beta[cell] == 1) continue;
    const double ratio = static_cast<double>(fields.alpha2[cell]) / fields.alpha1[cell];
    const double change = fields.beta[cell] - 1.0;
    sum = sum + change * (ratio * gradient_of(integrals[cell].gradient[0], a) +
                          1 / ratio * gradient_of(integrals[cell].gradient[1], a));
  }
  if (finest.inverse_diagonal[corner] == 0) sum = {0, 0, 0, 0};
  r[corner] = r[corner] + (sum - b[corner]);
  b[corner] = sum;
}

}  // namespace

void assemble_constraint(Stream& stream, const Depth& finest, const Integrals* integrals,
                         const FieldArrays& fields, Double3* b, Double3* r) {
  launch(stream, constraint_kernel, finest.topology.corner_count, finest, integrals, fields, b, r);
}

}  // namespace burnish::cuda
