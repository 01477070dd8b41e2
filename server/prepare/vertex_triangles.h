#pragma once

#include "common/base/groups.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Lists the triangles around each vertex, rising: sums gathered over them are the same for any
/// number of threads. A triangle that repeats a vertex is listed once per corner.
Groups<uint32_t, uint64_t> triangles_around_vertices(const TriangleMesh& mesh);

}  // namespace burnish
