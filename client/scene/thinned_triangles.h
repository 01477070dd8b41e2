#pragma once

#include <cstdint>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Returns at most `triangles_max` triangles of the mesh's vertices, for a quick picture. One
/// vertex stands for all in its cell of a grid; triangles within two cells go. A mesh that is small
/// enough keeps its triangles. Needs: a valid mesh and triangles_max > 0. Cost: O(vertices +
/// triangles).
std::vector<Triangle> thinned_triangles(const TriangleMesh& mesh, uint64_t triangles_max);

}  // namespace burnish
