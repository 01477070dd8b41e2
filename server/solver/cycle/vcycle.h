#pragma once

#include "server/solver/cycle/backend.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Corrects x of a depth by the depths above: they make a correction from its residual, then x is
/// relaxed. The part of the cycle below that uses the depths above.
inline void correct_from_above(Backend& backend, const Multigrid& on, int depth);

/// Coarse functions are poor at weak parts. At the finest depth patches make up for it.
inline bool is_corrected_twice(const Multigrid& on, int depth) {
  return on.plan->has_weak_parts(depth) && depth < on.hierarchy->finest;
}

/// Runs one V-cycle from a zero correction: x ≈ S⁻¹ f at this depth. It is a W-cycle at weak parts.
/// It is symmetric, because relax() is the transpose of relax_from_zero(), and at coarse depths its
/// own transpose. So it can precondition conjugate gradients. Source: section 5.2, "Solving the
/// System".
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

/// Makes x ≈ S⁻¹ f at this depth: takes the result of full multigrid at the depths above and
/// relaxes it once. If f is smooth, as after a small change of the metric, the result is nearer
/// than a V-cycle's, with half of its products at this depth. Not symmetric, so only the first
/// direction of conjugate gradients may use it.
inline void run_nested_iteration(Backend& backend, const Multigrid& on, int depth) {
  if (depth == on.hierarchy->coarsest) return backend.solve_coarsest();
  backend.restrict_from_zero(depth);
  run_full_multigrid(backend, on, depth - 1);
  backend.prolong_correction(depth);
  backend.relax(depth);
}

/// Does run_nested_iteration() with a correction after it, at all depths. For a cold start, where f
/// is as far away as it can be.
inline void run_full_multigrid(Backend& backend, const Multigrid& on, int depth) {
  run_nested_iteration(backend, on, depth);
  if (depth > on.hierarchy->coarsest) correct_from_above(backend, on, depth);
}

}  // namespace burnish
