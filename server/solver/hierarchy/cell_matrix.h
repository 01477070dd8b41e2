#pragma once

#include <array>
#include <cstdint>

#include "common/grid/cell_corners.h"

namespace burnish {

/// Returns the index of the pair {a, b} of local corners in a packed table: (0,1) ... (0,7), (1,2)
/// ...
inline constexpr int pair_index(int a, int b) {
  const int low = a < b ? a : b, high = a < b ? b : a;
  return low * 7 - low * (low - 1) / 2 + (high - low - 1);
}

/// Returns one axis of ∫ ⟨v, ∇B_a⟩ v over a cell; v is the direction of its stiffness ℓ. It is Σ_b
/// ℓ_ab x_b, because Σ_b x_b B_b is the place x itself. Rows add up to zero, so only the pairs of a
/// with the corners opposite along the axis count. `pair(p)`: ℓ's value at pair_index().
template <typename Pair>
constexpr double gradient_of(Pair&& pair, int a, int axis) {
  double sum = 0;
#pragma GCC unroll 8
  for (int step = 1; step < 8; ++step)
    if ((step >> axis & 1) != 0) sum += pair(pair_index(a, a ^ step));
  return (a >> axis & 1) != 0 ? -sum : sum;
}

/// A cell's symmetric 8×8 share of a system matrix, as off-diagonal pairs and row sums. The
/// diagonal is the row sum less the off-diagonals. Separate sums keep the mass term, which at small
/// α is many orders below the stiffness.
struct CellMatrix {
  std::array<double, kPairsPerCell> pair;
  std::array<double, 8> row_sum;
};

/// Weights of the combined integrals of section 5.2 ("Down-sampling"): α1α2 ρ + (α2/α1) ℓ¹ +
/// (α1/α2) ℓ². Units: α in grid units.
struct CombineWeights {
  double mass;
  double stiffness1;
  double stiffness2;
};

constexpr CombineWeights combine_weights(double alpha1, double alpha2) {
  return {alpha1 * alpha2, alpha2 / alpha1, alpha1 / alpha2};
}

/// A held line has so many times the stiffness of its cell. With more, coarse functions would lock
/// along it: ten times as much doubles the cycles. RimAnchor takes back the rest.
inline constexpr double kHeldLineStiffness = 8;

/// Returns the weight of ∫ B_a B_b along the held lines in a cell with these weights. One of the
/// two stiffnesses is at least 1.
constexpr double held_line_weight(const CombineWeights& by) {
  const double stiffness = by.stiffness1 > by.stiffness2 ? by.stiffness1 : by.stiffness2;
  return kHeldLineStiffness * (by.mass > stiffness ? by.mass : stiffness);
}

}  // namespace burnish
