#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "common/base/types.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"

namespace burnish {

/// The sum of area vectors (normal times twice the area) around something that has a normal, before
/// and after a move.
struct AreaVectors {
  Vec3d before = Vec3d::Zero();
  Vec3d after = Vec3d::Zero();

  /// Adds a triangle by its corners.
  void add(const std::array<Vec3d, 3>& corners_before, const std::array<Vec3d, 3>& corners_after);

  /// Adds a triangle.
  void add(const MovedMesh& moved, const Triangle& triangle);

  /// Returns the normal after the move. Its length and its side of the surface stay. It stays as a
  /// whole if no triangle moved, if it has no length, or if the triangles have no area.
  Vec3d turn(const Vec3d& normal) const;
};

/// The area vectors around each vertex.
std::vector<AreaVectors> gather_vertex_areas(const MovedMesh& moved);

}  // namespace burnish
