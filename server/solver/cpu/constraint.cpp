#include "server/solver/cpu/constraint.h"

#include "server/solver/cpu/scratch.h"

namespace burnish::cpu {

namespace {

/// What a cell's two gradients count for; both are zero where β = 1.
struct GradientWeights {
  double first, second;
};

// sum += weight · g of local corner a; the last corner's is minus the sum of the others', since
// Σ_a ∇B_a = 0.
void add_gradient(const std::array<double, 21>& gradient, int a, double weight, double (&sum)[3]) {
  if (a < 7) {
    for (int axis = 0; axis < 3; ++axis) sum[axis] += weight * gradient[3 * a + axis];
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    double others = 0;
    for (int other = 0; other < 7; ++other) others += gradient[3 * other + axis];
    sum[axis] -= weight * others;
  }
}

}  // namespace

void assemble_constraint(const PreparedMesh& prepared, const CpuDepth& finest,
                         std::span<const float> alpha1, std::span<const float> alpha2,
                         std::span<const float> beta, std::vector<Double4>& b) {
  const SparseGrid& grid = finest.topology.grid;
  Scratch<GradientWeights> weights(beta.size());
#pragma omp parallel for schedule(static)
  for (size_t cell = 0; cell < beta.size(); ++cell) {
    const double ratio = static_cast<double>(alpha2[cell]) / alpha1[cell];
    weights[cell] = {(beta[cell] - 1.0) * ratio, (beta[cell] - 1.0) / ratio};
  }
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner) {
    double sum[3] = {};
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t cell = grid.cells_of_corner[corner][a];
      if (cell == kNone || weights[cell].first == 0) continue;
      add_gradient(prepared.integrals[cell].gradient[0], a, weights[cell].first, sum);
      add_gradient(prepared.integrals[cell].gradient[1], a, weights[cell].second, sum);
    }
    b[corner] = finest.inverse_diagonal[corner] > 0 ? Double4(sum[0], sum[1], sum[2], 0)
                                                    : Double4(Double4::Zero());
  }
}

}  // namespace burnish::cpu
