#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Does q = S p for the exact S as Σ_J S_IJ (p_J − p_I) + m_I p_I, which loses nothing for smooth
/// p. Zero at pinned corners. [begin, end) of corners must consist of whole tiles of the stencil;
/// the last tile may end with the corners. Starts no threads.
void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Float4>& p,
                   std::vector<Double3>& q, int32_t begin, int32_t end);
void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Double3>& p,
                   std::vector<Double3>& q, int32_t begin, int32_t end);

}  // namespace burnish::cpu
