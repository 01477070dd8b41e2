#pragma once

#include <Eigen/Cholesky>

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// The direct solve of the coarsest depth: a dense Cholesky factor in double of the diagonally
/// scaled matrix, regularised by 1e-5 (less lets rounding grow over hundreds of idle cycles).
class CoarsestSolver {
 public:
  void factor(const CpuDepth& depth);
  void solve(CpuDepth& depth) const;  ///< x = S⁻¹ f
  uint64_t byte_count() const { return factor_.matrixLLT().size() * sizeof(double); }

 private:
  Eigen::VectorXd scale_;  // D^-½, 0 where pinned
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace burnish::cpu
