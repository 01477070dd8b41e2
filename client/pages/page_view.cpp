#include "client/pages/page_view.h"

#include <algorithm>

namespace burnish {

namespace {

Eigen::Vector4f relative_plane(const Eigen::Vector4d& plane, const Vec3d& origin) {
  const Vec3d normal = plane.head<3>();
  Eigen::Vector4d moved = plane;
  moved.w() += normal.dot(origin);
  return (moved / normal.norm()).cast<float>();
}

float height_over(const Eigen::Vector4f& plane, const Vec3f& point) {
  return plane.head<3>().dot(point) + plane.w();
}

}  // namespace

PageView make_page_view(const Camera& camera, const ImageSize& size, const PageGrid& grid) {
  const Eigen::Matrix4d projection = projection_matrix(camera, size.aspect());
  const Eigen::Matrix4d clip = projection * view_matrix(camera);
  const Vec3d back = camera_axes(camera).row(2).transpose();
  PageView view;
  view.eye = (camera.target + camera.distance * back - grid.origin).cast<float>();
  view.parallel = camera.orthographic;
  const double nearest =
      view.parallel ? camera.distance : projection(2, 3) / (projection(2, 2) - 1);
  view.nearest = static_cast<float>(nearest);
  view.pixels_at_one = static_cast<float>(0.5 * size.height * projection(1, 1) *
                                          (view.parallel ? camera.distance : 1));
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1}) {
      const Eigen::Vector4d plane = clip.row(3) + (side == 0 ? 1.0 : -1.0) * clip.row(axis);
      view.planes[2 * axis + side] = relative_plane(plane, grid.origin);
    }
  return view;
}

bool is_visible(const PageView& view, const PageBounds& bounds, float largest_move) {
  const float radius = bounds.radius + largest_move;
  return std::ranges::all_of(view.planes, [&](const Eigen::Vector4f& plane) {
    return height_over(plane, bounds.centre) >= -radius;
  });
}

bool is_inside(const PageView& view, const PageBounds& bounds, float largest_move) {
  const float radius = bounds.radius + largest_move;
  return std::ranges::all_of(view.planes, [&](const Eigen::Vector4f& plane) {
    return height_over(plane, bounds.centre) >= radius;
  });
}

}  // namespace burnish
