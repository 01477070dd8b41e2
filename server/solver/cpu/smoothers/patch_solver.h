#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/hierarchy/patches.h"

namespace burnish::cpu {

/// Solves a depth's patches one by one for the current residual: Gauss-Seidel over patches, colour
/// after colour. Each patch has the Cholesky factor L of its block of S, so the solved matrix stays
/// positive definite in float32, whatever its condition number.
class PatchSolver {
 public:
  /// Keeps a reference to `patches`.
  explicit PatchSolver(const Patches& patches);

  void factor(const CpuDepth& depth);  ///< call after a new matrix
  /// Does the same, with the same bits, if the rows or pins of some corners alone are new.
  void factor(const CpuDepth& depth, std::span<const int32_t> corners);
  void relax_forwards(CpuDepth& depth) const;
  void relax_backwards(CpuDepth& depth) const;  ///< the transpose: colours in reverse
  int32_t count() const { return patches_.count(); }
  uint64_t byte_count() const { return bytes_of(entry_); }

 private:
  void factor_one(const CpuDepth& depth, int32_t patch);
  void factor_some(const CpuDepth& depth, std::span<const int32_t> which);
  void relax(CpuDepth& depth, int32_t patch) const;
  void relax_colour(CpuDepth& depth, int32_t colour) const;

  const Patches& patches_;
  std::vector<float> entry_;  // L of every patch by rows with an inverted diagonal; 0 where pinned
};

}  // namespace burnish::cpu
