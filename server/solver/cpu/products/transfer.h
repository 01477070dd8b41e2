#pragma once

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// coarse.f = Pᵀ r, zero where pinned. Shapes: one r per corner of `fine`.
void restrict_to_coarse(const CpuDepth& fine, const std::vector<Float4>& r, CpuDepth& coarse);

/// fine.x += P coarse.x, but not where pinned.
void add_prolonged(const CpuDepth& coarse, CpuDepth& fine);

}  // namespace burnish::cpu
