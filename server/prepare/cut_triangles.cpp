#include "server/prepare/cut_triangles.h"

namespace burnish {

static constexpr double kDegenerateRatio = 1e-12;  // twice the area over the longest edge squared

bool has_area(const std::array<Vec3d, 3>& corners) {
  const Vec3d ab = corners[1] - corners[0], bc = corners[2] - corners[1];
  const Vec3d ca = corners[0] - corners[2];
  const double longest = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
  return ab.cross(ca).norm() > kDegenerateRatio * longest;
}

}  // namespace burnish
