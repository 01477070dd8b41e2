#pragma once

#include "server/prepare/cell_integrals.h"
#include "server/prepare/cell_pieces.h"
#include "server/prepare/curvature.h"
#include "server/prepare/grid_mesh.h"

namespace burnish {

/// The sources of the cells' integrals. Units: grid; curvature in file units.
struct Surface {
  const GridMesh& mesh;
  const MeshCurvature& curvature;
  double length_unit;

  /// Adds a triangle's part in a cell; returns its area. `of_triangle` is the triangle's curvature.
  double integrate(const CellPiece& piece, const TriangleCurvature& of_triangle,
                   CellIntegrator& integrator) const;

 private:
  // Returns whether rounding alone gives principal directions: flat or spherical.
  bool is_umbilic(const TriangleCurvature& of_triangle) const;
};

}  // namespace burnish
