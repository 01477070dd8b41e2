#pragma once

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// The loops in which the V-cycle spends its time: products of a depth's rows with a vector, each
/// with what is done to the result while it is near.

/// r = length·(f − S x) + kept·r, zero where pinned. What r was is not read where none is kept.
void compute_residual(CpuDepth& depth, float length = 1, float kept = 0);

/// x = length·A source + kept·x, likewise.
void relax_by(CpuDepth& depth, const StencilMatrix& a, const std::vector<Float4>& source,
              float length, float kept);

}  // namespace burnish::cpu
