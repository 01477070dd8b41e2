#pragma once

#include <array>
#include <cstddef>

namespace burnish {

/// A point of a symmetric rule on a triangle: barycentric coordinates and a weight. The weights of
/// a rule sum to 1, so an integral is area × Σ weight·f.
struct QuadraturePoint {
  double a, b, c;
  double weight;
};

/// Exact for polynomials of degree 6: ρ needs it (trilinear × trilinear on a plane), ℓ needs less.
/// Source: Cowper 1973, Dunavant 1985.
extern const std::array<QuadraturePoint, 12> kDegree6Rule;

}  // namespace burnish
