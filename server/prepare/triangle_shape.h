#pragma once

#include <array>

#include "common/mesh/triangle_mesh.h"
#include "server/prepare/tangent_tensor.h"

namespace burnish {

/// Edges, plane and Voronoi areas of one triangle. Only differences of positions enter, so that a
/// far origin costs no digits.
struct TriangleShape {
  std::array<Vec3d, 3> edges;     ///< edges[k] faces corner k, from corner k+1 to corner k+2
  std::array<double, 3> squared;  ///< their squared lengths
  Vec3d cross;                    ///< normal × twice the area
  double twice_area;
  bool has_plane;  ///< false when rounding decides where the normal points

  /// u along the longest edge, where least squares over the edges is conditioned best.
  /// Needs: has_plane.
  TangentFrame frame() const;

  /// Weight of `cross` in the normal of the vertex at corner k: exact on spheres, whatever the
  /// triangles' shapes. Source: Max 1999. Needs: has_plane.
  double normal_weight(int k) const { return 1 / (squared[(k + 1) % 3] * squared[(k + 2) % 3]); }

  /// The part of the area that is nearest to corner k. Needs: has_plane.
  double voronoi_area(int k) const;
};

/// Lengths are divided by `unit`, a power of two.
TriangleShape make_triangle_shape(const TriangleMesh& mesh, const Triangle& triangle, double unit);

}  // namespace burnish
