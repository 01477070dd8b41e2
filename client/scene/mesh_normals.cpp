#include "client/scene/mesh_normals.h"

#include <cmath>

namespace burnish {

static void add_weighted_normal(std::span<const Vec3d> vertices, const Triangle& triangle,
                                std::span<Vec3d> sums) {
  const Vec3d& a = vertices[triangle[0]];
  const Vec3d normal =
      (vertices[triangle[1]] - a).cross(vertices[triangle[2]] - a).stableNormalized();
  for (int corner = 0; corner < 3; ++corner) {
    const Vec3d& at = vertices[triangle[corner]];
    const Vec3d to_next = (vertices[triangle[(corner + 1) % 3]] - at).stableNormalized();
    const Vec3d to_last = (vertices[triangle[(corner + 2) % 3]] - at).stableNormalized();
    const double angle = std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
    sums[triangle[corner]] += angle * normal;
  }
}

std::vector<Vec3f> vertex_normals(std::span<const Vec3d> vertices,
                                  std::span<const Triangle> triangles) {
  std::vector<Vec3d> sums(vertices.size(), Vec3d::Zero());
  for (const Triangle& triangle : triangles) add_weighted_normal(vertices, triangle, sums);
  std::vector<Vec3f> normals(vertices.size(), Vec3f::UnitZ());
  for (size_t v = 0; v < sums.size(); ++v) {
    const double length = sums[v].norm();
    if (length > 0) normals[v] = (sums[v] / length).cast<float>();
  }
  return normals;
}

}  // namespace burnish
