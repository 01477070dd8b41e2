#include "client/scene/axes_gizmo.h"

#include <algorithm>
#include <utility>

namespace burnish {

// Pixels of a screen with 96 dots per inch.
static constexpr double kGizmoMargin = 8, kGizmoRadius = 42;
static constexpr double kAxisReach = 32, kAxisEndRadius = 9;
static constexpr double kWidthForGizmo = 320, kHeightForGizmo = 200;

// The coordinate that an axis is of, and its sign.
static int number_of(UpAxis axis) {
  return static_cast<int>(axis) % 3;
}

static double sign_of(UpAxis axis) {
  return axis <= UpAxis::kZ ? 1 : -1;
}

static StandardView view_towards(const Camera& camera, UpAxis axis) {
  StandardView nearest = StandardView::kFront;
  double most = -1;
  for (int i = 0; i < kStandardViews; ++i) {
    const auto view = static_cast<StandardView>(i);
    const Eigen::Matrix3d axes = camera_axes(seen_from(camera, view));
    const double along = sign_of(axis) * axes(2, number_of(axis));
    if (along > most) nearest = view;
    most = std::max(most, along);
  }
  return nearest;
}

std::optional<AxesGizmo> axes_gizmo(const Camera& camera, const ImageSize& size,
                                    double pixel_ratio) {
  if (size.width < kWidthForGizmo * pixel_ratio || size.height < kHeightForGizmo * pixel_ratio)
    return std::nullopt;
  AxesGizmo gizmo;
  gizmo.radius = kGizmoRadius * pixel_ratio;
  gizmo.end_radius = kAxisEndRadius * pixel_ratio;
  const double middle = (kGizmoMargin + kGizmoRadius) * pixel_ratio;
  gizmo.middle = {middle, middle};
  const Eigen::Matrix3d axes = camera_axes(camera);
  for (size_t i = 0; i < gizmo.ends.size(); ++i) {
    const auto axis = static_cast<UpAxis>(i);
    const int number = number_of(axis);
    const double reach = kAxisReach * pixel_ratio * sign_of(axis);
    AxisEnd& end = gizmo.ends[i];
    end = {axis, view_towards(camera, axis), gizmo.middle, sign_of(axis) * axes(2, number)};
    end.place.x() += reach * axes(0, number);
    end.place.y() -= reach * axes(1, number);
    for (size_t k = i; k > 0 && gizmo.ends[k].depth < gizmo.ends[k - 1].depth; --k)
      std::swap(gizmo.ends[k], gizmo.ends[k - 1]);
  }
  return gizmo;
}

const AxisEnd* end_at(const AxesGizmo& gizmo, const Eigen::Vector2d& pixel) {
  const AxisEnd* nearest = nullptr;
  for (const AxisEnd& end : gizmo.ends)
    if ((pixel - end.place).norm() <= gizmo.end_radius) nearest = &end;
  return nearest;
}

bool covers(const AxesGizmo& gizmo, const Eigen::Vector2d& pixel) {
  return (pixel - gizmo.middle).norm() <= gizmo.radius;
}

}  // namespace burnish
