#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace burnish {

/// Index of the pair (a, b), a < b, of local corners in a packed table: (0,1) ... (0,7), (1,2) ...
inline constexpr int pair_index(int a, int b) {
  return a < b ? a * 7 - a * (a - 1) / 2 + (b - a - 1) : pair_index(b, a);
}

/// A cell's symmetric 8×8 share of a system matrix, as off-diagonal pairs and row sums. The
/// diagonal is the row sum less the off-diagonals; keeping the sums apart keeps the mass term,
/// which is many orders below the stiffness at small α, exact in float32.
struct CellMatrix {
  std::array<float, 28> pair;
  std::array<float, 8> row_sum;
};
static_assert(sizeof(CellMatrix) == 144);

/// The largest weight of ρ. Where a corner touches little surface, ρ's diagonal in float32 is wrong
/// by far more than its rounding; under a weight much above this the error outgrows the stiffness
/// and S is no longer definite. The grid resolves nothing there: the mass alone decides, and u is
/// proportional to b / weight.
inline constexpr double kMassWeightMax = 1024;

/// The combined integrals of section 5.2 ("Down-sampling"): α1α2 ρ + (α2/α1) ℓ¹ + (α1/α2) ℓ².
/// Units: α in grid units.
struct CombineWeights {
  float mass;
  float stiffness1;
  float stiffness2;
};

inline constexpr CombineWeights combine_weights(double alpha1, double alpha2) {
  return {static_cast<float>(std::min(alpha1 * alpha2, kMassWeightMax)),
          static_cast<float>(alpha2 / alpha1), static_cast<float>(alpha1 / alpha2)};
}

/// What the constraint is multiplied with, so that u stays what the whole weight would give.
/// Units: α in grid units.
inline constexpr double constraint_weight(double alpha1, double alpha2) {
  return std::min(1.0, kMassWeightMax / (alpha1 * alpha2));
}

}  // namespace burnish
