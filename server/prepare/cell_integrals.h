#pragma once

#include <array>

#include "common/base/types.h"
#include "server/prepare/clip.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Sums the integrals of section 4.3 over the pieces of surface in one cell, in double.
/// Units: grid; positions are relative to the cell's least corner.
class CellIntegrator {
 public:
  /// Adds one convex planar piece. v1 and v2 are the principal directions on it; where it has none
  /// (`umbilic`: flat or spherical) each of ℓ¹, ℓ² and of the gradients takes half of both, so that
  /// nothing depends on an arbitrary choice.
  void add(const Polygon& piece, const Vec3d& v1, const Vec3d& v2, bool umbilic);

  double area() const { return area_; }
  CellIntegrals integrals() const;

  /// ρ, ℓ¹ or ℓ² as full symmetric matrices, and ∫⟨v_i, ∇B_a⟩ v_i: for tests and references.
  using Square = std::array<std::array<double, 8>, 8>;
  const Square& mass() const { return mass_; }

 private:
  void add_triangle(const Vec3d& p, const Vec3d& q, const Vec3d& r, const Vec3d& v1,
                    const Vec3d& v2, bool umbilic);

  double area_ = 0;
  Square mass_ = {};
  std::array<double, 8> mass_row_sum_ = {};
  std::array<Square, 2> stiffness_ = {};
  std::array<std::array<Vec3d, 8>, 2> gradient_ = zero_gradient();

  static std::array<std::array<Vec3d, 8>, 2> zero_gradient();
};

/// The share of the squared normal derivative ∫⟨n, ∇B_a⟩⟨n, ∇B_b⟩ that is added to ℓ¹ + ℓ².
/// Functions that vanish on a flat piece of surface have no energy at all; this lifts them above
/// the rounding of double and moves the surface by less than 1e-9 of a cell.
inline constexpr double kNormalStiffness = 1e-9;

/// Below this area (cells²) a piece is a rounding artefact of clipping.
inline constexpr double kPieceAreaMin = 1e-22;

}  // namespace burnish
