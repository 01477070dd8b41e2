#pragma once

#include "common/base/groups.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Lists the triangles around each vertex, rising, so that sums over them do not depend on the
/// number of threads. Lists a triangle that repeats a vertex once per corner.
Groups<uint32_t, uint64_t> triangles_around_vertices(const TriangleMesh& mesh);

}  // namespace burnish
