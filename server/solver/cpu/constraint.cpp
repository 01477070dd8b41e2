#include "server/solver/cpu/constraint.h"

namespace burnish::cpu {

// g of local corner a; the last is minus the sum of the others, since Σ_a ∇B_a = 0.
static Double4 gradient_of(const std::array<float, 21>& gradient, int a) {
  Double4 g = Double4::Zero();
  if (a < 7) {
    for (int axis = 0; axis < 3; ++axis) g[axis] = gradient[3 * a + axis];
  } else {
    for (int other = 0; other < 7; ++other)
      for (int axis = 0; axis < 3; ++axis) g[axis] -= gradient[3 * other + axis];
  }
  return g;
}

void assemble_constraint(const PreparedMesh& prepared, const CpuDepth& finest,
                         std::span<const float> alpha1, std::span<const float> alpha2,
                         std::span<const float> beta, std::vector<Double4>& b) {
  const SparseGrid& grid = finest.topology.grid;
  const double scale = prepared.alpha_scale();
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner) {
    Double4 sum = Double4::Zero();
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t cell = grid.cells_of_corner[corner][a];
      if (cell == kNone || beta[cell] == 1) continue;
      const double ratio = static_cast<double>(alpha2[cell]) / alpha1[cell];
      const CellIntegrals& integrals = prepared.integrals[cell];
      const double weight = constraint_weight(alpha1[cell] * scale, alpha2[cell] * scale);
      sum += weight * (beta[cell] - 1.0) *
             (ratio * gradient_of(integrals.gradient[0], a) +
              gradient_of(integrals.gradient[1], a) / ratio);
    }
    b[corner] = finest.inverse_diagonal[corner] > 0 ? sum : Double4(Double4::Zero());
  }
}

}  // namespace burnish::cpu
