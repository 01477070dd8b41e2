#pragma once

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Solves a depth's patches one by one for what is left of the residual: Gauss-Seidel over patches,
/// colour after colour. Each has the inverse W of the Cholesky factor of its block of S, so that
/// S⁻¹ ≈ WᵀW stays positive definite in float32, whatever its condition number.
class PatchSolver {
 public:
  explicit PatchSolver(const HierarchyDepth& topology);

  void factor(const CpuDepth& depth);  ///< after a new matrix
  void relax_forwards(CpuDepth& depth) const;
  void relax_backwards(CpuDepth& depth) const;  ///< the transpose: the colours backwards
  uint64_t byte_count() const { return bytes_of(factor_inverse_); }

 private:
  void factor(const CpuDepth& depth, int32_t patch);
  void relax(CpuDepth& depth, int32_t patch) const;
  void relax_colour(CpuDepth& depth, int32_t colour) const;

  const Patches& patches_;
  std::vector<float> factor_inverse_;  // W of every patch, its lower triangle by rows
};

}  // namespace burnish::cpu
