#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "client/scene/camera.h"

namespace burnish {

/// Returns how far along the ray a box begins, file units: 0 if the ray begins inside. Returns
/// nothing if the ray misses the box or the box is empty. A miss by rounding counts as a hit.
inline std::optional<double> distance_to_box(const Ray& ray, const Eigen::AlignedBox3d& box) {
  constexpr double kTouchPart = 1e-9;  // of the box and its distance
  if (box.isEmpty()) return std::nullopt;
  const double touch = kTouchPart * (box.diagonal().norm() + (box.center() - ray.origin).norm());
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.min()[axis] - touch - ray.origin[axis];
    const double high = box.max()[axis] + touch - ray.origin[axis];
    const double along = ray.direction[axis];
    if (along == 0) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    enter = std::max(enter, std::min(low / along, high / along));
    leave = std::min(leave, std::max(low / along, high / along));
  }
  if (enter > leave) return std::nullopt;
  return enter;
}

}  // namespace burnish
