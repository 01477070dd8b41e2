#include "server/solver/cpu/coarsest.h"

#include <cmath>

#include "common/base/check.h"

namespace burnish::cpu {

static constexpr double kRegularisation = 1e-5;

void CoarsestSolver::factor(const CpuDepth& depth) {
  const int32_t n = depth.corner_count();
  const Stencil& stencil = depth.topology.stencil;
  scale_.resize(n);
  for (int32_t i = 0; i < n; ++i) scale_[i] = std::sqrt(depth.inverse_diagonal[i]);
  Eigen::MatrixXd scaled = Eigen::MatrixXd::Identity(n, n) * (1 + kRegularisation);
  for (int32_t i = 0; i < n; ++i)
    for (int64_t k = stencil.row_start[i]; k < stencil.row_start[i + 1]; ++k)
      scaled(i, stencil.column[k]) = depth.system.entry[k] * scale_[i] * scale_[stencil.column[k]];
  factor_.compute(scaled);
  BURNISH_CHECK(factor_.info() == Eigen::Success, "the regularised coarsest matrix is definite");
}

void CoarsestSolver::solve(CpuDepth& depth) const {
  const int32_t n = depth.corner_count();
  Eigen::MatrixXd columns(n, 3);
  for (int32_t i = 0; i < n; ++i)
    columns.row(i) = scale_[i] * depth.f[i].head<3>().cast<double>().matrix().transpose();
  factor_.solveInPlace(columns);
  for (int32_t i = 0; i < n; ++i)
    depth.x[i].head<3>() = (scale_[i] * columns.row(i)).cast<float>().transpose().array();
}

}  // namespace burnish::cpu
