#include "server/prepare/vertex_triangles.h"

namespace burnish {

// Counts a vertex two places further up, so that filling moves each start to its own place.
VertexTriangles::VertexTriangles(const MeshView& mesh, const ScratchSpace& space,
                                 const LoopPart& part)
    : start_(space, mesh.vertices.size() + 2), triangles_(space, 3 * mesh.triangles.size()) {
  for_each_heard(part.of(0, 0.3), mesh.triangles.size(), [&](size_t t) {
    for (const uint32_t v : mesh.triangles[t]) ++start_[v + 2];
  });
  for_each_heard(part.of(0.3, 0.4), mesh.vertices.size(),
                 [&](size_t v) { start_[v + 2] += start_[v + 1]; });
  for_each_heard(part.of(0.4, 1), mesh.triangles.size(), [&](size_t t) {
    for (const uint32_t v : mesh.triangles[t])
      triangles_[start_[v + 1]++] = static_cast<uint32_t>(t);
  });
}

}  // namespace burnish
