#include "server/solver/cpu/constraint.h"

#include "common/base/dispatch.h"
#include "server/solver/cpu/scratch.h"

namespace burnish::cpu {

namespace {

using Gradient = std::array<double, 21>;
/// A cell's share of b, by local corner and axis.
using CellConstraint = std::array<double, 24>;

// The last corner's share is minus the sum of the others', since Σ_a ∇B_a = 0.
BURNISH_DISPATCH void combine(const std::array<Gradient, 2>& gradient, double first, double second,
                              CellConstraint& out) {
  for (int i = 0; i < 21; ++i) out[i] = first * gradient[0][i] + second * gradient[1][i];
  for (int axis = 0; axis < 3; ++axis) {
    double others = 0;
    for (int a = 0; a < 7; ++a) others += out[3 * a + axis];
    out[21 + axis] = -others;
  }
}

}  // namespace

std::vector<double> ratios_of(std::span<const float> alpha1, std::span<const float> alpha2) {
  std::vector<double> ratios(alpha1.size());
  for (size_t c = 0; c < ratios.size(); ++c) ratios[c] = static_cast<double>(alpha2[c]) / alpha1[c];
  return ratios;
}

void assemble_constraint(const PreparedMesh& prepared, const CpuDepth& finest,
                         std::span<const double> ratio, std::span<const float> beta,
                         std::vector<Double4>& b, std::vector<Double4>& r) {
  const SparseGrid& grid = finest.topology.grid;
  Scratch<CellConstraint> shares(beta.size());
#pragma omp parallel for schedule(static)
  for (size_t cell = 0; cell < beta.size(); ++cell) {
    const double change = beta[cell] - 1.0;
    if (change == 0)
      shares[cell].fill(0);
    else
      combine(prepared.integrals[cell].gradient, change * ratio[cell], change / ratio[cell],
              shares[cell]);
  }
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner) {
    double sum[3] = {};
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t cell = grid.cells_of_corner[corner][a];
      if (cell == kNone) continue;
      for (int axis = 0; axis < 3; ++axis) sum[axis] += shares[cell][3 * a + axis];
    }
    Double4 constraint(sum[0], sum[1], sum[2], 0);
    if (finest.inverse_diagonal[corner] == 0) constraint.setZero();
    r[corner] += constraint - b[corner];
    b[corner] = constraint;
  }
}

}  // namespace burnish::cpu
