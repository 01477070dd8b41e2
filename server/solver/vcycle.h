#pragma once

#include "server/solver/backend.h"

namespace burnish {

/// One V-cycle from a zero correction: x ≈ S⁻¹ f at the finest depth. Symmetric, because relax()
/// is the transpose of relax_from_zero(): fit to precondition conjugate gradients.
/// Source: section 5.2, "Solving the System".
inline void run_vcycle(Backend& backend, int coarsest, int finest) {
  for (int depth = finest; depth > coarsest; --depth) {
    backend.relax_from_zero(depth);
    backend.restrict_residual(depth);
  }
  backend.solve_coarsest();
  for (int depth = coarsest + 1; depth <= finest; ++depth) {
    backend.prolong_correction(depth);
    backend.relax(depth);
  }
}

inline void run_full_multigrid(Backend& backend, int coarsest, int finest);

/// x ≈ S⁻¹ f at the finest depth from what full multigrid finds above it, relaxed once: where f is
/// smooth, as after a small change of the metric, it is nearer than a V-cycle comes, and has half
/// of its products at the finest depth. Not symmetric, and so for the first direction of conjugate
/// gradients alone.
inline void run_nested_iteration(Backend& backend, int coarsest, int finest) {
  if (finest == coarsest) return backend.solve_coarsest();
  backend.restrict_from_zero(finest);
  run_full_multigrid(backend, coarsest, finest - 1);
  backend.prolong_correction(finest);
  backend.relax(finest);
}

/// The same with a correction after it, and so at all depths: where f is as far as it can be, from
/// a cold start.
inline void run_full_multigrid(Backend& backend, int coarsest, int finest) {
  run_nested_iteration(backend, coarsest, finest);
  if (finest == coarsest) return;
  backend.restrict_residual(finest);
  run_vcycle(backend, coarsest, finest - 1);
  backend.prolong_correction(finest);
  backend.relax(finest);
}

}  // namespace burnish
