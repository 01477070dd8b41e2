#include "client/scene/mesh_normals.h"

#include <array>

#include "common/mesh/corner_normals.h"

namespace burnish {

static void add_corner_normals(std::span<const Vec3d> vertices, const Triangle& triangle,
                               std::span<Vec3d> sums) {
  const auto normals =
      corner_normals(vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]);
  for (int corner = 0; corner < 3; ++corner) sums[triangle[corner]] += normals[corner];
}

std::vector<Vec3f> vertex_normals(std::span<const Vec3d> vertices,
                                  std::span<const Triangle> triangles) {
  std::vector<Vec3d> sums(vertices.size(), Vec3d::Zero());
  for (const Triangle& triangle : triangles) add_corner_normals(vertices, triangle, sums);
  std::vector<Vec3f> normals(vertices.size(), Vec3f::UnitZ());
  for (size_t v = 0; v < sums.size(); ++v) {
    const double length = sums[v].norm();
    if (length > 0) normals[v] = (sums[v] / length).cast<float>();
  }
  return normals;
}

}  // namespace burnish
