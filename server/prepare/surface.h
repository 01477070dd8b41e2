#pragma once

#include <cmath>
#include <span>

#include "server/prepare/cell_integrals.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/curvature.h"

namespace burnish {

/// The sources of the cells' integrals. Units: grid; curvature in file units.
struct Surface {
  std::span<const Triangle> triangles;
  std::span<const Vec3d> positions;  ///< one per vertex, snapped
  std::span<const TriangleCurvature> curvature;
  double length_unit;

  /// Returns whether rounding alone gives the triangle principal directions: flat or spherical.
  bool is_umbilic(uint32_t triangle) const;
  /// Adds a triangle's part in a cell; returns its area.
  double integrate(const CellPiece& piece, CellIntegrator& integrator) const;
};

}  // namespace burnish
