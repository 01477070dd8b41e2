#pragma once

#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish::reference {

/// Principal curvatures of one triangle: kappa1 >= kappa2 algebraically, v1 and v2 unit vectors in
/// its plane. Units: kappa in 1 / file units; positive where convex seen from outside.
struct TriangleCurvature {
  double kappa1 = 0;
  double kappa2 = 0;
  Vec3d v1 = Vec3d::Zero();
  Vec3d v2 = Vec3d::Zero();
};

/// Twice the area is at most this times the square of the longest edge: the triangle has no area,
/// no normal, and no part in anything.
inline constexpr double kDegenerateRatio = 1e-12;
bool is_degenerate(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// Source: Rusinkiewicz 2004 with the normals of Max 1999 and, as weights, the part of a triangle
/// that lies nearest to each corner. The three corners' tensors are carried into the triangle's
/// plane, averaged with equal weights, and diagonalised; a vertex whose normals cancel (the edge of
/// two triangles back to back) has no plane and adds nothing. A closed mesh (no edge has one
/// triangle only) of negative signed volume counts as turned inside out. Shapes: one per triangle;
/// degenerate ones get zeros.
std::vector<TriangleCurvature> triangle_curvature(const TriangleMesh& mesh);

/// The areas of the parts of a triangle that lie nearest to a, b and c: they sum to its area.
Vec3d nearest_areas(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// True for a closed mesh whose signed volume is negative.
bool is_inside_out(const TriangleMesh& mesh);

}  // namespace burnish::reference
