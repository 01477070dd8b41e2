#pragma once

#include <Eigen/SparseCholesky>

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Solves the coarsest depth directly: a sparse Cholesky factor in double of the diagonally scaled
/// matrix, regularised by 1e-5. With less, rounding grows over hundreds of idle cycles. Separate
/// pieces of surface are separate blocks, so thousands of them stay cheap.
class CoarsestSolver {
 public:
  void factor(const CpuDepth& depth);
  void solve(CpuDepth& depth) const;  ///< x = S⁻¹ f
  uint64_t byte_count() const { return entries_ * (sizeof(double) + sizeof(int)); }

 private:
  Eigen::VectorXd scale_;  // D^-½, 0 where pinned
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor_;
  uint64_t entries_ = 0;
};

}  // namespace burnish::cpu
