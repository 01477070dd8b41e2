#pragma once

#include <array>

#include "common/base/types.h"
#include "server/prepare/cell_moments.h"
#include "server/prepare/clip.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Sums the integrals of section 4.3 over the pieces of surface in one cell, in double.
/// Units: grid; positions are relative to the cell's least corner.
class CellIntegrator {
 public:
  /// Adds one convex planar piece. v1 and v2 are the principal directions on it. If it has none
  /// (`umbilic`: flat or spherical), ℓ¹ and ℓ² each take half of both, so that nothing depends on
  /// an arbitrary choice.
  void add(const Polygon& piece, const Vec3d& v1, const Vec3d& v2, bool umbilic);

  double area() const { return area_; }
  /// Returns the integrals of all added pieces.
  CellIntegrals integrals();

 private:
  using Tensor = std::array<double, 6>;  // xx, yy, zz, yz, xz, xy

  void add_triangle(const std::array<Vec3d, 3>& corners, const std::array<Tensor, 2>& tensors);
  void flush();

  double area_ = 0;
  int waiting_ = 0;  // triangles in the batch
  TriangleBatch batch_;
  CellMoments<Double8> moments_;
};

/// The share of ∫_cell ⟨∇B_a, ∇B_b⟩, times the area in the cell, that is added to ℓ¹ + ℓ². A sliver
/// h cells wide has functions of its corners with h⁴ of the energy of the others. The share keeps
/// them above the rounding of matrices. In a skin of 279,151 vertices it moves eight vertices by
/// more than 1e-6 of the diagonal, by 1e-5. They belong to a speck that shares a cell with a
/// surface and is torn off it by a fifth of a cell. With a smaller share, corners without a vertex
/// nearby grow in idle sessions.
inline constexpr double kCellStiffness = 1e-11;

/// A piece below this area (cells²) is a rounding artefact of clipping.
inline constexpr double kPieceAreaMin = 1e-22;

}  // namespace burnish
