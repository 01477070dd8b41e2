#pragma once

#include <array>
#include <functional>
#include <vector>

#include "common/base/types.h"

namespace burnish::reference {

/// A point of the integer lattice: a cell's least corner, or a corner. Ordered by i, then j, k.
using Lattice = std::array<int, 3>;

/// A convex planar polygon.
using Polygon = std::vector<Vec3d>;

/// Rounds coordinates within 1e-7 of a grid plane onto it. Units: grid.
Vec3d snapped(const Vec3d& grid_point);

/// Cuts a triangle at the grid planes, first those of x, then y, then z, and gives each piece to
/// `sink` with its cell. A piece that lies in a plane belongs to the cell above it. Units: grid.
void cut_at_grid_planes(const Polygon& triangle,
                        const std::function<void(const Lattice& cell, const Polygon&)>& sink);

/// A point of a quadrature rule with its weight, an area.
struct QuadraturePoint {
  Vec3d position;
  double weight;
};

/// Returns points and weights over a convex polygon, exact for polynomials of degree 8: a fan of
/// triangles, each the image of a square (one side shrunk to a corner) under a 5 x 5 Gauss-Legendre
/// rule.
std::vector<QuadraturePoint> quadrature(const Polygon& polygon);

}  // namespace burnish::reference
