#pragma once

#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cycle/patches.h"

namespace burnish::cpu {

/// Solves a depth's patches one by one for what is left of the residual: Gauss-Seidel over patches,
/// colour after colour. Each has the Cholesky factor L of its block of S, so that what is solved
/// stays positive definite in float32, whatever its condition number.
class PatchSolver {
 public:
  /// Keeps `patches`.
  explicit PatchSolver(const Patches& patches);

  void factor(const CpuDepth& depth);  ///< after a new matrix
  void relax_forwards(CpuDepth& depth) const;
  void relax_backwards(CpuDepth& depth) const;  ///< the transpose: the colours backwards
  uint64_t byte_count() const { return bytes_of(entry_); }

 private:
  void factor(const CpuDepth& depth, int32_t patch);
  void relax(CpuDepth& depth, int32_t patch) const;
  void relax_colour(CpuDepth& depth, int32_t colour) const;

  const Patches& patches_;
  std::vector<float> entry_;  // L of every patch by rows, its diagonal inverted: 0 where pinned
};

}  // namespace burnish::cpu
