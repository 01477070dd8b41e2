#pragma once

#include <span>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// The matrices and inverse diagonals of all depths, the coarsest first, and the finest matrix in
/// double if `exact` is given. A coarse depth's cells are Σ over children of Pᵀ K P. Shapes: one α
/// of each kind per cell of the finest depth. Units: user α. Source: section 5.2.
void assemble(const PreparedMesh& prepared, std::span<const float> alpha1,
              std::span<const float> alpha2, std::span<CpuDepth> depths,
              ExactMatrix* exact = nullptr);

}  // namespace burnish::cpu
