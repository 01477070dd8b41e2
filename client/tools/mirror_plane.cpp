#include "client/tools/mirror_plane.h"

#include <string>

namespace burnish {

Vec3d mirrored(Vec3d point, const MirrorPlane& plane) {
  point[plane.axis] = 2 * plane.at - point[plane.axis];
  return point;
}

Stroke mirrored(Stroke stroke, const MirrorPlane& plane) {
  for (Vec3d& point : stroke.path) point = mirrored(point, plane);
  return stroke;
}

Result<int> parse_axis(std::string_view name) {
  constexpr std::string_view kAxes = "xyz";
  const size_t axis = name.size() == 1 ? kAxes.find(name[0]) : std::string_view::npos;
  if (axis != std::string_view::npos) return static_cast<int>(axis);
  return invalid_argument("axis '" + std::string(name) + "' is not x, y or z");
}

}  // namespace burnish
