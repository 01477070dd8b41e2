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

}  // namespace burnish
