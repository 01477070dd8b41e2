#pragma once

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Does coarse.f = Pᵀ r, zero at pinned corners. Shapes: one r per corner of `fine`.
void restrict_to_coarse(const CpuDepth& fine, const std::vector<Float4>& r, CpuDepth& coarse);

/// Does fine.x += P coarse.x, except at pinned corners.
void add_prolonged(const CpuDepth& coarse, CpuDepth& fine);

}  // namespace burnish::cpu
