#pragma once

#include <span>

#include "server/fields/alphas.h"
#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Makes the matrices and inverse diagonals of all depths, the coarsest first, and the finest
/// matrix in double if `exact` is given. A coarse depth's cells are Σ over children of Pᵀ K P.
/// Source: section 5.2.
void assemble(const PreparedMesh& prepared, const CellAlphas& alphas, std::span<CpuDepth> depths,
              ExactMatrix* exact = nullptr);

}  // namespace burnish::cpu
