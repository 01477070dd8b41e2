#pragma once

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// coarse.f = Pᵀ fine.r, zero where pinned.
void restrict_to_coarse(const CpuDepth& fine, CpuDepth& coarse);

/// fine.x += P coarse.x, but not where pinned.
void add_prolonged(const CpuDepth& coarse, CpuDepth& fine);

}  // namespace burnish::cpu
