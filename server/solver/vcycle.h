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

/// x ≈ S⁻¹ f at the finest depth by full multigrid: each depth begins with what the one above
/// found, which is where most of a cold start's error is, and takes one V-cycle. 1.6
/// V-cycles by count of products; not symmetric, and so for the first direction of conjugate
/// gradients alone.
inline void run_full_multigrid(Backend& backend, int coarsest, int finest) {
  for (int depth = finest; depth > coarsest; --depth) {
    backend.clear_correction(depth);
    backend.restrict_residual(depth);
  }
  backend.solve_coarsest();
  for (int depth = coarsest + 1; depth <= finest; ++depth) {
    backend.clear_correction(depth);
    backend.prolong_correction(depth);
    backend.relax(depth);
    backend.restrict_residual(depth);
    run_vcycle(backend, coarsest, depth - 1);
    backend.prolong_correction(depth);
    backend.relax(depth);
  }
}

}  // namespace burnish
