#include "server/prepare/vertex_triangles.h"

namespace burnish {

Groups<uint32_t, uint64_t> triangles_around_vertices(const TriangleMesh& mesh) {
  return group_by<uint32_t, uint64_t>(mesh.vertices.size(), [&](auto&& add) {
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const uint32_t v : mesh.triangles[t]) add(v, static_cast<uint32_t>(t));
  });
}

}  // namespace burnish
