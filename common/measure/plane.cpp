#include "common/measure/plane.h"

#include <cmath>

#include "common/base/limits.h"
#include "common/base/text.h"

namespace burnish {

PlaneAxes axes_of(const Plane& plane) {
  constexpr double kLevel = 0.999;
  const Vec3d wanted = std::abs(plane.normal.y()) < kLevel ? Vec3d::UnitY() : Vec3d::UnitZ();
  const Vec3d up = (wanted - wanted.dot(plane.normal) * plane.normal).normalized();
  return {up.cross(plane.normal), up};
}

static Status check_values(const char* what, const Vec3d& values) {
  for (const double value : values)
    if (!(std::abs(value) <= kCoordinateMagnitudeMax))
      return invalid_argument(std::string("the plane's ") + what + " has the coordinate " +
                              shortest_text(value) + ", the limit is " +
                              shortest_text(kCoordinateMagnitudeMax));
  return Status::ok();
}

Result<Plane> make_plane(const Vec3d& point, const Vec3d& direction) {
  RETURN_IF_ERROR(check_values("point", point));
  RETURN_IF_ERROR(check_values("direction", direction));
  const Vec3d normal = direction.stableNormalized();
  if (normal.squaredNorm() < 0.5) return invalid_argument("the plane's direction has length 0");
  return Plane{point, normal};
}

}  // namespace burnish
