#include "server/solver/cpu/products/coarsest.h"

#include <cmath>
#include <vector>

#include "common/base/check.h"

namespace burnish::cpu {

static constexpr double kRegularisation = 1e-5;
static constexpr double kRegularisationMax = 100;  // rows have 27 entries of at most about 1

void CoarsestSolver::factor(const CpuDepth& depth) {
  const int32_t n = depth.corner_count();
  const Stencil& stencil = depth.topology.stencil;
  scale_.resize(n);
  for (int32_t i = 0; i < n; ++i) scale_[i] = std::sqrt(depth.inverse_diagonal[i]);
  std::vector<Eigen::Triplet<double>> entries;
  for (int32_t i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1 + kRegularisation);
    for (auto [k, end] = stencil.row(i); k < end; ++k)
      entries.emplace_back(i, stencil.column[k],
                           depth.system.entry[k] * scale_[i] * scale_[stencil.column[k]]);
  }
  Eigen::SparseMatrix<double> scaled(n, n);
  scaled.setFromTriplets(entries.begin(), entries.end());
  if (entries_ == 0) factor_.analyzePattern(scaled);
  factor_.factorize(scaled);
  for (double more = 9 * kRegularisation; factor_.info() != Eigen::Success; more *= 10) {
    BURNISH_CHECK(more < kRegularisationMax, "the coarsest matrix is finite");
    scaled.diagonal().array() += more;
    factor_.factorize(scaled);
  }
  entries_ = static_cast<uint64_t>(factor_.matrixL().nestedExpression().nonZeros());
}

void CoarsestSolver::solve(CpuDepth& depth) const {
  const int32_t n = depth.corner_count();
  Eigen::MatrixXd columns(n, 3);
  for (int32_t i = 0; i < n; ++i)
    columns.row(i) = scale_[i] * depth.f[i].head<3>().cast<double>().matrix().transpose();
  columns = factor_.solve(columns).eval();
  for (int32_t i = 0; i < n; ++i)
    depth.x[i].head<3>() = (scale_[i] * columns.row(i)).cast<float>().transpose().array();
}

}  // namespace burnish::cpu
