#include "client/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {

static constexpr double kRadiansPerDegree = std::numbers::pi / 180;
static constexpr double kMargin = 1.06;
static constexpr double kNearestDepth = 1e-3;  // part of the distance, when the eye is in the scene

static double half_height_tangent(const Camera& camera) {
  return std::tan(0.5 * camera.field_of_view_degrees * kRadiansPerDegree);
}

Eigen::Matrix3d camera_axes(const Camera& camera) {
  const double azimuth = camera.azimuth_degrees * kRadiansPerDegree;
  const double elevation = camera.elevation_degrees * kRadiansPerDegree;
  const Vec3d right(std::cos(azimuth), 0, -std::sin(azimuth));
  const Vec3d back(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                   std::cos(azimuth) * std::cos(elevation));
  Eigen::Matrix3d axes;
  axes << right.transpose(), back.cross(right).transpose(), back.transpose();
  return axes * to_turntable(camera.up);
}

Eigen::Matrix4d view_matrix(const Camera& camera) {
  const Eigen::Matrix3d axes = camera_axes(camera);
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = axes;
  view.topRightCorner<3, 1>() = -axes * camera.target - Vec3d(0, 0, camera.distance);
  return view;
}

static Eigen::Matrix4d parallel_projection(const Camera& camera, double aspect) {
  const double scale = camera.zoom / (half_height_tangent(camera) * camera.distance);
  return Eigen::Vector4d(scale / aspect, scale, -1 / camera.scene_radius, 1).asDiagonal() *
         Eigen::Matrix4d(Eigen::Affine3d(Eigen::Translation3d(0, 0, camera.distance)).matrix());
}

Eigen::Matrix4d projection_matrix(const Camera& camera, double aspect) {
  if (camera.orthographic) return parallel_projection(camera, aspect);
  const double scale = camera.zoom / half_height_tangent(camera);
  const double near =
      std::max(camera.distance - camera.scene_radius, kNearestDepth * camera.distance);
  const double far = camera.distance + camera.scene_radius;
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = scale / aspect;
  projection(1, 1) = scale;
  projection(2, 2) = -(far + near) / (far - near);
  projection(2, 3) = -2 * far * near / (far - near);
  projection(3, 2) = -1;
  return projection;
}

Camera frame_all(Camera camera, const Eigen::AlignedBox3d& box, double aspect) {
  const Eigen::Matrix3d axes = camera_axes(camera);
  const double tangent = half_height_tangent(camera) / kMargin;
  camera.target = box.center();
  camera.scene_radius = 0.5 * box.diagonal().norm() * kMargin;
  camera.distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d seen =
        axes * (box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - camera.target);
    const double needed = std::max(std::abs(seen.x()) / aspect, std::abs(seen.y())) / tangent;
    camera.distance = std::max(camera.distance, camera.orthographic ? needed : seen.z() + needed);
  }
  return camera;
}

}  // namespace burnish
