#pragma once

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// The loops that take most time of the V-cycle: products of a depth's rows with a vector. Each
/// product also does its further work on the result while that is in cache.

/// Does r = length·(f − S x) + kept·r, zero at pinned corners. If kept is 0, it does not read r.
void compute_residual(CpuDepth& depth, float length = 1, float kept = 0);

/// Does x = length·A source + kept·x, likewise.
void relax_by(CpuDepth& depth, const StencilMatrix& a, const std::vector<Float4>& source,
              float length, float kept);

}  // namespace burnish::cpu
