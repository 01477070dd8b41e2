#include "tests/bench/refined_mesh.h"

#include <algorithm>
#include <unordered_map>

#include "client/scene/mesh_normals.h"

namespace burnish {

namespace {

/// The vertices in the middle of edges.
class EdgeMiddles {
 public:
  EdgeMiddles(const TriangleMesh& mesh, TriangleMesh& refined)
      : mesh_(mesh), refined_(refined), normals_(vertex_normals(mesh.vertices, mesh.triangles)) {}

  uint32_t between(uint32_t a, uint32_t b) {
    const uint64_t edge = uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto next = static_cast<uint32_t>(refined_.vertices.size());
    const auto [at, is_new] = middles_.try_emplace(edge, next);
    if (is_new) refined_.vertices.push_back(middle(std::min(a, b), std::max(a, b)));
    return at->second;
  }

 private:
  // Half way on the cubic curve with these ends and tangents.
  Vec3d middle(uint32_t a, uint32_t b) const {
    const Vec3d along = mesh_.vertices[b] - mesh_.vertices[a];
    const auto tangent = [&](uint32_t v) -> Vec3d {
      const Vec3d normal = normals_[v].cast<double>();
      return along - normal * normal.dot(along);
    };
    return (mesh_.vertices[a] + mesh_.vertices[b]) / 2 + (tangent(a) - tangent(b)) / 8;
  }

  const TriangleMesh& mesh_;
  TriangleMesh& refined_;
  std::vector<Vec3f> normals_;
  std::unordered_map<uint64_t, uint32_t> middles_;
};

}  // namespace

TriangleMesh refined_mesh(const TriangleMesh& mesh) {
  TriangleMesh refined;
  refined.vertices = mesh.vertices;
  refined.triangles.reserve(4 * mesh.triangles.size());
  EdgeMiddles middles(mesh, refined);
  for (const auto& [a, b, c] : mesh.triangles) {
    const uint32_t ab = middles.between(a, b), bc = middles.between(b, c),
                   ca = middles.between(c, a);
    for (const Triangle& part :
         {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
      refined.triangles.push_back(part);
  }
  return refined;
}

}  // namespace burnish
