#include "common/mesh/rewrite/moved/moved_normals.h"

#include <cmath>

namespace burnish {

static Vec3d area_vector(const std::array<Vec3d, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

void AreaVectors::add(const std::array<Vec3d, 3>& corners_before,
                      const std::array<Vec3d, 3>& corners_after) {
  before += area_vector(corners_before);
  after += area_vector(corners_after);
}

void AreaVectors::add(const MovedMesh& moved, const Triangle& triangle) {
  std::array<Vec3d, 3> corners_before, corners_after;
  for (size_t corner = 0; corner < 3; ++corner) {
    corners_before[corner] = moved.before[triangle[corner]];
    corners_after[corner] = moved.after.vertices[triangle[corner]];
  }
  add(corners_before, corners_after);
}

// Lengths near 1 are 1 and rounding. Others mean something, or are the scale of an integer type.
Vec3d AreaVectors::turn(const Vec3d& normal) const {
  constexpr double kRounding = 0.01;
  if (before == after) return normal;
  double length = normal.norm();
  const Vec3d direction = after.stableNormalized();
  if (!(length > 0) || !std::isfinite(length) || !(direction.squaredNorm() > 0.5)) return normal;
  if (std::abs(length - 1) < kRounding) length = 1;
  if (normal.dot(before) < 0) length = -length;
  return length * direction + Vec3d::Zero();  // turns -0 into 0
}

std::vector<AreaVectors> gather_vertex_areas(const MovedMesh& moved) {
  std::vector<AreaVectors> areas(moved.before.size());
  for (const Triangle& triangle : moved.after.triangles) {
    AreaVectors area;
    area.add(moved, triangle);
    for (const uint32_t vertex : triangle) {
      areas[vertex].before += area.before;
      areas[vertex].after += area.after;
    }
  }
  return areas;
}

}  // namespace burnish
