#pragma once

#include "server/solver/backend.h"
#include "server/solver/hierarchy.h"

namespace burnish {

/// The part of the cycle below that goes by the depths above one: x of that depth is corrected by
/// what they make of its residual, and relaxed.
inline void correct_from_above(Backend& backend, const Hierarchy& hierarchy, int depth);

/// One V-cycle from a zero correction: x ≈ S⁻¹ f at this depth; a W-cycle as far as depths are
/// corrected twice. Symmetric, because relax() is the transpose of relax_from_zero(), and at coarse
/// depths its own: fit to precondition conjugate gradients.
/// Source: section 5.2, "Solving the System".
inline void run_vcycle(Backend& backend, const Hierarchy& hierarchy, int depth) {
  if (depth == hierarchy.coarsest) return backend.solve_coarsest();
  backend.relax_from_zero(depth);
  correct_from_above(backend, hierarchy, depth);
  if (hierarchy.at(depth).is_corrected_twice) correct_from_above(backend, hierarchy, depth);
}

inline void correct_from_above(Backend& backend, const Hierarchy& hierarchy, int depth) {
  backend.restrict_residual(depth);
  run_vcycle(backend, hierarchy, depth - 1);
  backend.prolong_correction(depth);
  backend.relax(depth);
}

inline void run_full_multigrid(Backend& backend, const Hierarchy& hierarchy, int depth);

/// x ≈ S⁻¹ f at this depth from what full multigrid finds above it, relaxed once: where f is
/// smooth, as after a small change of the metric, it is nearer than a V-cycle comes, and has half
/// of its products at this depth. Not symmetric, and so for the first direction of conjugate
/// gradients alone.
inline void run_nested_iteration(Backend& backend, const Hierarchy& hierarchy, int depth) {
  if (depth == hierarchy.coarsest) return backend.solve_coarsest();
  backend.restrict_from_zero(depth);
  run_full_multigrid(backend, hierarchy, depth - 1);
  backend.prolong_correction(depth);
  backend.relax(depth);
}

/// The same with a correction after it, and so at all depths: where f is as far as it can be, from
/// a cold start.
inline void run_full_multigrid(Backend& backend, const Hierarchy& hierarchy, int depth) {
  run_nested_iteration(backend, hierarchy, depth);
  if (depth > hierarchy.coarsest) correct_from_above(backend, hierarchy, depth);
}

}  // namespace burnish
