#include "server/prepare/vertex_triangles.h"

namespace burnish {

// Counts a vertex two places further up, so that filling moves each start to its own place.
VertexTriangles::VertexTriangles(const MeshView& mesh, const ScratchSpace& space)
    : start_(space, mesh.vertices.size() + 2), triangles_(space, 3 * mesh.triangles.size()) {
  for (const Triangle& triangle : mesh.triangles)
    for (const uint32_t v : triangle) ++start_[v + 2];
  for (size_t i = 2; i < start_.size(); ++i) start_[i] += start_[i - 1];
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const uint32_t v : mesh.triangles[t])
      triangles_[start_[v + 1]++] = static_cast<uint32_t>(t);
}

}  // namespace burnish
