#pragma once

#include <functional>

#include "common/mesh/statistics/statistics.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A sphere around the origin: an icosahedron split `level` times.
TriangleMesh test_sphere(int level, double radius);

/// `side` × `side` quads over [0, 1]², split in two and placed by `surface`; facing Su × Sv.
TriangleMesh test_patch(int side, const std::function<Vec3d(double, double)>& surface);

/// An open cylinder around z, facing outwards, with a seam of doubled vertices at x = radius.
TriangleMesh test_cylinder(double radius, double height);

/// Box and volume of the mesh; `is_closed` as given.
MeshStatistics test_statistics(const TriangleMesh& mesh, bool is_closed);

/// The same surface facing the other way.
TriangleMesh inside_out(TriangleMesh mesh);

}  // namespace burnish
