#pragma once

#include "tests/bench/input.h"

namespace burnish {

/// Bytes that one call of the CPU backend with the default smoother moves between memory and
/// processor. It counts like the triad: each array once per loop that reads it and once per loop
/// that writes it; nothing stays in the caches between two loops. The bytes over the triad's
/// bandwidth are a lower bound of the time of a system larger than the caches. Only joined loops or
/// smaller numbers could beat it. Units: bytes.
struct MemoryFloor {
  double step = 0;
  double rhs = 0;     ///< Solver::set_gradient_scale() of another slider
  double matrix = 0;  ///< Solver::set_metric() of nearly the same α everywhere
};

MemoryFloor memory_floor(const BenchSystem& system);

}  // namespace burnish
