#include "server/solver/cpu/constraint.h"

#include <algorithm>

#include "common/base/dispatch.h"
#include "server/solver/cpu/scratch.h"

namespace burnish::cpu {

namespace {

// With fewer changed cells than this part of all, their corners are summed one by one: a cell's
// share is then computed for each of its corners anew.
constexpr size_t kFewCellsDivisor = 8;

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

namespace {

struct Inputs {
  const PreparedMesh& prepared;
  const CpuDepth& finest;
  std::span<const double> ratio;
  std::span<const float> beta;

  void share(int32_t cell, CellConstraint& out) const {
    const double change = beta[cell] - 1.0;
    if (change == 0)
      out.fill(0);
    else
      combine(prepared.integrals[cell].gradient, change * ratio[cell], change / ratio[cell], out);
  }
};

// Sums what `share_of` says of the cells around a corner.
template <typename ShareOf>
void sum_corner(const CpuDepth& finest, int32_t corner, ShareOf&& share_of, Double4& b,
                Double4& r) {
  double sum[3] = {};
  for (int a = 0; a < kCornersPerCell; ++a) {
    const int32_t cell = finest.topology.grid.cells_of_corner[corner][a];
    if (cell == kNone) continue;
    const CellConstraint& share = share_of(cell);
    for (int axis = 0; axis < 3; ++axis) sum[axis] += share[3 * a + axis];
  }
  Double4 constraint(sum[0], sum[1], sum[2], 0);
  if (finest.inverse_diagonal[corner] == 0) constraint.setZero();
  r += constraint - b;
  b = constraint;
}

void assemble_all(const Inputs& in, std::vector<Double4>& b, std::vector<Double4>& r) {
  Scratch<CellConstraint> shares(in.beta.size());
#pragma omp parallel for schedule(static)
  for (size_t cell = 0; cell < in.beta.size(); ++cell)
    in.share(static_cast<int32_t>(cell), shares[cell]);
  const auto share_of = [&](int32_t cell) -> const CellConstraint& { return shares[cell]; };
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < in.finest.corner_count(); ++corner)
    sum_corner(in.finest, corner, share_of, b[corner], r[corner]);
}

// Only the corners of cells whose β changed.
void assemble_changed(const Inputs& in, std::span<const float> before, std::vector<Double4>& b,
                      std::vector<Double4>& r) {
  const auto changed = [&](int32_t cell) { return cell != kNone && in.beta[cell] != before[cell]; };
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < in.finest.corner_count(); ++corner) {
    if (std::ranges::none_of(in.finest.topology.grid.cells_of_corner[corner], changed)) continue;
    CellConstraint share;
    const auto share_of = [&](int32_t cell) -> const CellConstraint& {
      in.share(cell, share);
      return share;
    };
    sum_corner(in.finest, corner, share_of, b[corner], r[corner]);
  }
}

int64_t count_changed(std::span<const float> beta, std::span<const float> before) {
  int64_t changed = 0;
#pragma omp parallel for schedule(static) reduction(+ : changed)
  for (size_t cell = 0; cell < beta.size(); ++cell) changed += beta[cell] != before[cell];
  return changed;
}

}  // namespace

void assemble_constraint(const PreparedMesh& prepared, const CpuDepth& finest,
                         std::span<const double> ratio, std::span<const float> beta,
                         std::span<const float> before, std::vector<Double4>& b,
                         std::vector<Double4>& r) {
  const Inputs in = {prepared, finest, ratio, beta};
  const auto few = static_cast<int64_t>(beta.size() / kFewCellsDivisor);
  if (!before.empty() && count_changed(beta, before) < few)
    assemble_changed(in, before, b, r);
  else
    assemble_all(in, b, r);
}

}  // namespace burnish::cpu
