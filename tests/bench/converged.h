#pragma once

#include <vector>

#include "server/solver/solver.h"
#include "tests/bench/input.h"

namespace burnish {

/// Distances of vertices over the bounding box's diagonal.
struct VertexDistance {
  double max = 0;
  double rms = 0;
};

/// The converged surface of one system: the default solver far below the bar of exports. Its outer
/// iteration is in double, so it converges to double's rounding.
struct Converged {
  std::vector<Vec3d> vertices;
  double diagonal = 0;
  int cycles = 0;
  double residual = 0;    ///< the true one, recomputed, diagonally scaled, over the norm of b
  double correction = 0;  ///< estimate of the remaining distance, over the diagonal
  double moved_max = 0;   ///< largest displacement, over the diagonal

  /// Fails: failed_precondition if it has not converged; names scan, residual and limit.
  static Result<Converged> solve(const BenchSystem& system, const FieldsView& fields);

  VertexDistance distance(const Solver& solver) const;
};

}  // namespace burnish
