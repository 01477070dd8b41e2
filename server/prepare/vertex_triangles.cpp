#include "server/prepare/vertex_triangles.h"

namespace burnish {

VertexTriangles::VertexTriangles(const TriangleMesh& mesh)
    : begin_(mesh.vertices.size() + 1, 0), triangles_(3 * mesh.triangles.size()) {
  for (const Triangle& triangle : mesh.triangles)
    for (uint32_t v : triangle) ++begin_[v];
  uint64_t end = 0;
  for (uint64_t& count : begin_) count = end += count;
  // Each begin is now its vertex's end; filling from the back moves it to the front.
  for (size_t t = mesh.triangles.size(); t-- > 0;)
    for (uint32_t v : mesh.triangles[t]) triangles_[--begin_[v]] = static_cast<uint32_t>(t);
}

}  // namespace burnish
