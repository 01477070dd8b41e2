#pragma once

#include "server/solver/cycle/backend.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// The part of the cycle below that goes by the depths above one: x of that depth is corrected by
/// what they make of its residual, and relaxed.
inline void correct_from_above(Backend& backend, const Multigrid& on, int depth);

/// Where parts are weak coarse functions are poor. At the finest depth patches make up for it.
inline bool is_corrected_twice(const Multigrid& on, int depth) {
  return on.plan->has_weak_parts(depth) && depth < on.hierarchy->finest;
}

/// One V-cycle from a zero correction: x ≈ S⁻¹ f at this depth; a W-cycle where parts are weak.
/// Symmetric, because relax() is the transpose of relax_from_zero(), and at coarse depths its own:
/// fit to precondition conjugate gradients. Source: section 5.2, "Solving the System".
inline void run_vcycle(Backend& backend, const Multigrid& on, int depth) {
  if (depth == on.hierarchy->coarsest) return backend.solve_coarsest();
  backend.relax_from_zero(depth);
  correct_from_above(backend, on, depth);
  if (is_corrected_twice(on, depth)) correct_from_above(backend, on, depth);
}

inline void correct_from_above(Backend& backend, const Multigrid& on, int depth) {
  backend.restrict_residual(depth);
  run_vcycle(backend, on, depth - 1);
  backend.prolong_correction(depth);
  backend.relax(depth);
}

inline void run_full_multigrid(Backend& backend, const Multigrid& on, int depth);

/// x ≈ S⁻¹ f at this depth from what full multigrid finds above it, relaxed once: where f is
/// smooth, as after a small change of the metric, it is nearer than a V-cycle comes, and has half
/// of its products at this depth. Not symmetric, and so for the first direction of conjugate
/// gradients alone.
inline void run_nested_iteration(Backend& backend, const Multigrid& on, int depth) {
  if (depth == on.hierarchy->coarsest) return backend.solve_coarsest();
  backend.restrict_from_zero(depth);
  run_full_multigrid(backend, on, depth - 1);
  backend.prolong_correction(depth);
  backend.relax(depth);
}

/// The same with a correction after it, and so at all depths: where f is as far as it can be, from
/// a cold start.
inline void run_full_multigrid(Backend& backend, const Multigrid& on, int depth) {
  run_nested_iteration(backend, on, depth);
  if (depth > on.hierarchy->coarsest) correct_from_above(backend, on, depth);
}

}  // namespace burnish
