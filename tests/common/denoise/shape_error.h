#pragma once

#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// How far a mesh is from the clean one that has the same triangles.
struct ShapeError {
  double angle = 0;     ///< mean between normals, by the clean areas, degrees
  double distance = 0;  ///< root mean square from vertices to the clean surface around, mean edges
  double volume = 0;    ///< change over the clean volume, percent; for closed surfaces
};

/// Needs: equal triangles; vertices at one place in `clean` are so in `mesh`.
ShapeError shape_error(const TriangleMesh& clean, const TriangleMesh& mesh);

/// Returns how many of `before`'s triangles turned by more than 90 degrees, over all of them.
double turned_share(const TriangleMesh& before, const TriangleMesh& after);

/// Returns the mesh with its vertices moved by `strength` times these moves.
TriangleMesh moved(const TriangleMesh& mesh, const std::vector<Vec3f>& moves, double strength = 1);

}  // namespace burnish
