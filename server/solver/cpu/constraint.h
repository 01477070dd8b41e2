#pragma once

#include <span>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// α2/α1 of every cell.
std::vector<double> ratios_of(std::span<const float> alpha1, std::span<const float> alpha2);

/// b_I = Σ_c (β−1)(α2/α1 g¹ + α1/α2 g²)_I, the right-hand side for the displacement: Eq. 4's
/// constraint less S c°; the residual r changes by as much. `ratio` is α2/α1. `before` is the β
/// that b was assembled from with the same ratio, or empty: what a dab leaves alone is not summed
/// again. Shapes: fields per cell, b and r per corner. Zero where pinned.
void assemble_constraint(const PreparedMesh& prepared, const CpuDepth& finest,
                         std::span<const double> ratio, std::span<const float> beta,
                         std::span<const float> before, std::vector<Double4>& b,
                         std::vector<Double4>& r);

}  // namespace burnish::cpu
