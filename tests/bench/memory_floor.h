#pragma once

#include "tests/bench/input.h"

namespace burnish {

/// What one call of the CPU backend with the default smoother moves between memory and processor,
/// counted as the triad counts: each array once for every loop that reads it and once for every
/// loop that writes it, nothing staying in the caches between two loops. Divided by the triad's
/// bandwidth it is the time below which a system larger than the caches cannot come unless loops
/// are joined or numbers made smaller. Units: bytes.
struct MemoryFloor {
  double step = 0;
  double rhs = 0;     ///< Solver::set_gradient_scale() of another slider
  double matrix = 0;  ///< Solver::set_metric() of nearly the same α everywhere
};

MemoryFloor memory_floor(const BenchSystem& system);

}  // namespace burnish
