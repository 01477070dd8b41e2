#include "client/model/view/zoom.h"

#include <algorithm>
#include <cmath>

#include "common/base/ratio.h"

namespace burnish {

static constexpr double kZoomPerStep = 0.88;
static constexpr double kCoveredMin = 0.1;     // of the picture's height, by the diagonal
static constexpr double kNearestToBox = 0.02;  // of the diagonal

static bool is_in_picture(const Camera& camera, const ImageSize& size, const Vec3d& point) {
  const Vec3d seen = (view_matrix(camera) * point.homogeneous()).head<3>();
  if (!camera.orthographic && seen.z() >= 0) return false;
  const Eigen::Vector2d pixel = pixel_of(camera, size, point);
  return pixel.minCoeff() >= 0 && pixel.x() < size.width && pixel.y() < size.height;
}

static bool is_before(const Camera& camera, const Eigen::AlignedBox3d& box) {
  const double nearest = kNearestToBox * box.diagonal().norm();
  if (camera.orthographic) return camera.distance > nearest;
  const Vec3d eye = camera.target + camera.distance * camera_axes(camera).row(2).transpose();
  return box.exteriorDistance(eye) > nearest;
}

Camera zoomed_by_wheel(const Camera& camera, const ImageSize& size, const ZoomPlace& place,
                       double steps, const Eigen::AlignedBox3d& box) {
  const Camera from = place.surface ? with_target_as_deep_as(camera, *place.surface) : camera;
  const double farthest = std::max(covered_part(from, box.diagonal().norm()) / kCoveredMin, 1.0);
  const double factor = std::min(power(kZoomPerStep, steps), farthest);
  const Camera to = zoomed_at(from, size, place.pixel, factor);
  const bool is_left_behind =
      steps > 0 && !place.surface && !(is_before(to, box) && is_in_picture(to, size, box.center()));
  return is_left_behind ? camera : to;
}

}  // namespace burnish
