#pragma once

#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish::reference {

/// Principal curvatures of one triangle: kappa1 >= kappa2 algebraically, v1 and v2 unit vectors in
/// its plane. Units: kappa in 1 / file units, positive if convex from outside.
struct TriangleCurvature {
  double kappa1 = 0;
  double kappa2 = 0;
  Vec3d v1 = Vec3d::Zero();
  Vec3d v2 = Vec3d::Zero();
};

/// If twice the area is at most this times the square of the longest edge, the triangle has no area
/// and no normal, and is ignored.
inline constexpr double kDegenerateRatio = 1e-12;
bool is_degenerate(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// Source: Rusinkiewicz 2004 with the normals of Max 1999. The weights are the parts of a triangle
/// that lie nearest to each corner. The three corners' tensors are carried into the triangle's
/// plane, averaged with equal weights, and diagonalised. A vertex whose normals cancel (the edge of
/// two triangles back to back) has no plane and adds nothing. A closed mesh (no edge has only one
/// triangle) of negative signed volume counts as turned inside out. Shapes: one per triangle;
/// degenerate ones get zeros.
std::vector<TriangleCurvature> triangle_curvature(const TriangleMesh& mesh);

/// Returns the areas of the parts of a triangle that lie nearest to a, b and c. They sum to its
/// area.
Vec3d nearest_areas(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// Returns true for a closed mesh whose signed volume is negative.
bool is_inside_out(const TriangleMesh& mesh);

}  // namespace burnish::reference
