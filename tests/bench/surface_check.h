#pragma once

#include <vector>

#include "common/base/status.h"
#include "server/solver/solver.h"
#include "tests/bench/input.h"

namespace burnish {

/// Holds the surfaces of several solvers of one scan to each other, and prints what it finds.
class SurfaceCheck {
 public:
  explicit SurfaceCheck(const BenchSystem& system) : system_(system) {}

  /// Solves from the scan for the first time. Fails: as the solver's device does.
  Status begin(Solver& solver);

  /// Solves from the scan for the second time, after whatever the solver did meanwhile. Fails:
  /// internal if the bits are others, or if the surface is too far from the first solver's.
  Status end(Solver& solver);

 private:
  using Surface = std::vector<Vec3f>;  // displacements of vertices, in cells

  Result<Surface> solve(Solver& solver) const;
  double between(const Surface& one, const Surface& other) const;

  const BenchSystem& system_;
  Surface of_first_solver_, of_first_run_;
};

}  // namespace burnish
