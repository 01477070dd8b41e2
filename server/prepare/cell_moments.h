#pragma once

#include "common/base/dispatch.h"

namespace burnish {

/// The two axes beside each one.
inline constexpr int kBeside[3][2] = {{1, 2}, {0, 2}, {0, 1}};

/// The parts of the integrals of one cell. Along an axis a trilinear basis function is h₀ = 1 − x
/// or h₁ = x. A product of two is β₀ = (1 − x)², β₁ = x(1 − x) or β₂ = x². The 27 integrals of
/// β_i(x) β_j(y) β_k(z) say all, because h₀ = β₀ + β₁, h₁ = β₁ + β₂ and 1 = β₀ + 2β₁ + β₂. Those of
/// derivatives are summed with two tensors S of the piece of surface, ℓ¹'s and ℓ²'s. T: a number,
/// or several that must still be added up.
template <typename T>
struct CellMoments {
  T mass[27] = {};        ///< ∫ β_i β_j β_k at i + 3j + 9k
  T along[2][3][9] = {};  ///< [axis r]: Σ S_rr ∫ β_j β_k at j + 3k, over the axes beside r
  T across[2][3][2][2][3] = {};  ///< [axis t][u][v][k]: Σ S_rs ∫ h_u h_v β_k with r, s beside t
};

/// Eight plane triangles inside a cell, one in each lane. A lane with zero area adds nothing.
struct TriangleBatch {
  static constexpr int kLanes = 8;

  Double8 corner[3][3] = {};  ///< [corner][axis], relative to the cell's least corner
  Double8 area = {};
  Double8 tensor[2][6] = {};  ///< v vᵀ: xx, yy, zz, yz, xz, xy
};

/// Adds the moments of the triangles to `sums`.
void add_moments(const TriangleBatch& triangles, CellMoments<Double8>& sums);

/// Returns the sums over the lanes.
CellMoments<double> sum_of_lanes(const CellMoments<Double8>& sums);

/// The share of the squared normal derivative ∫⟨n, ∇B_a⟩⟨n, ∇B_b⟩ that is added to ℓ¹ + ℓ².
/// Functions that vanish on a flat piece of surface have no energy. With less, a nearly flat sheet
/// has displacements that change by a thousand cells across it: a vertex that is rounded to the
/// lattice of pages then moves elsewhere, and solves take hundreds of cycles.
inline constexpr double kNormalStiffness = 1e-7;

}  // namespace burnish
