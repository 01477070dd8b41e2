#pragma once

#include <span>
#include <vector>

#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// The values of a fitted function, one per corner of the finest depth.
struct SignalFit {
  std::vector<Vec3f> corners;
  int steps = 0;        ///< of conjugate gradients
  bool is_met = false;  ///< the residual is below its bar
};

/// Returns the trilinear function on the grid that is nearest to a value at each vertex: least
/// squares over the vertices. A little stiffness fills corners that no vertex reaches. A constant
/// is met exactly, except for rounding. The same bits for any number of threads.
/// Shapes: one value per vertex; returns one per corner. Units: the values'.
SignalFit fit_signal(const Multigrid& on, std::span<const Vec3f> values);

/// Returns the bytes that fit_signal() and its values take while it runs, beside its result.
uint64_t predict_fit_bytes(const Multigrid& on);

}  // namespace burnish
