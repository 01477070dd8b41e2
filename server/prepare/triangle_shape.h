#pragma once

#include <array>

#include "common/mesh/triangle_mesh.h"
#include "server/prepare/tangent_tensor.h"

namespace burnish {

/// Edges, plane and Voronoi areas of one triangle. Uses only differences of positions, so a far
/// origin costs no digits.
struct TriangleShape {
  std::array<Vec3d, 3> edges;     ///< edges[k] faces corner k, from corner k+1 to corner k+2
  std::array<double, 3> squared;  ///< their squared lengths
  Vec3d cross;                    ///< normal × twice the area
  double twice_area;
  bool has_plane;  ///< false if rounding decides where the normal points

  /// Puts u along the longest edge, where the least squares over the edges are best conditioned.
  /// Needs: has_plane.
  TangentFrame frame() const;

  /// Returns the weight of `cross` in the normal of the vertex at corner k: exact on spheres,
  /// whatever the triangles' shapes. Source: Max 1999. Needs: has_plane.
  double normal_weight(int k) const { return 1 / (squared[(k + 1) % 3] * squared[(k + 2) % 3]); }

  /// Returns the part of the area that is nearest to corner k. Needs: has_plane.
  double voronoi_area(int k) const;
};

/// Divides lengths by `unit`, a power of two.
TriangleShape make_triangle_shape(const MeshView& mesh, const Triangle& triangle, double unit);

}  // namespace burnish
