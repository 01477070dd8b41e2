#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/scene/camera.h"

namespace burnish {

static constexpr double kElevationMax = 90;
static constexpr double kDistanceMinRadii = 1e-4;
static constexpr double kDistanceMaxRadii = 1e3;

// Returns the size of a pixel at distance 1, in camera space.
static double pixel_tangent(const Camera& camera, const ImageSize& size) {
  const double half = 0.5 * camera.field_of_view_degrees * std::numbers::pi / 180;
  return 2 * std::tan(half) / (camera.zoom * size.height);
}

// Returns the offset from the picture's middle, x right and y up, at distance 1.
static Eigen::Vector2d from_middle(const Camera& camera, const ImageSize& size,
                                   const Eigen::Vector2d& pixel) {
  const double tangent = pixel_tangent(camera, size);
  return {(pixel.x() - 0.5 * size.width) * tangent, (0.5 * size.height - pixel.y()) * tangent};
}

Ray pixel_ray(const Camera& camera, const ImageSize& size, const Eigen::Vector2d& pixel) {
  const Eigen::Matrix3d axes = camera_axes(camera);
  const Eigen::Vector2d seen = from_middle(camera, size, pixel);
  if (camera.orthographic) {
    const Vec3d place(seen.x() * camera.distance, seen.y() * camera.distance, camera.scene_radius);
    return {camera.target + axes.transpose() * place, -axes.row(2).transpose()};
  }
  const Vec3d direction = axes.transpose() * Vec3d(seen.x(), seen.y(), -1);
  return {camera.target + camera.distance * axes.row(2).transpose(), direction.normalized()};
}

Eigen::Vector2d pixel_of(const Camera& camera, const ImageSize& size, const Vec3d& point) {
  const Vec3d seen = (view_matrix(camera) * point.homogeneous()).head<3>();
  const double distance = camera.orthographic ? camera.distance : -seen.z();
  const double scale = 1 / (pixel_tangent(camera, size) * distance);
  return {0.5 * size.width + scale * seen.x(), 0.5 * size.height - scale * seen.y()};
}

double pixel_length(const Camera& camera, const ImageSize& size) {
  return pixel_tangent(camera, size) * camera.distance;
}

Camera turned(Camera camera, double azimuth_degrees, double elevation_degrees) {
  camera.azimuth_degrees = std::remainder(camera.azimuth_degrees + azimuth_degrees, 360);
  camera.elevation_degrees =
      std::clamp(camera.elevation_degrees + elevation_degrees, -kElevationMax, kElevationMax);
  return camera;
}

Camera panned(Camera camera, const ImageSize& size, const Eigen::Vector2d& pixels) {
  const Eigen::Matrix3d axes = camera_axes(camera);
  const double length = pixel_length(camera, size);
  camera.target += axes.transpose() * Vec3d(-pixels.x() * length, pixels.y() * length, 0);
  return camera;
}

Camera zoomed_at(Camera camera, const ImageSize& size, const Eigen::Vector2d& pixel,
                 double factor) {
  const double nearest = kDistanceMinRadii * camera.scene_radius;
  const double farthest = kDistanceMaxRadii * camera.scene_radius;
  const double distance = std::clamp(camera.distance * factor, nearest, farthest);
  const Eigen::Vector2d seen = from_middle(camera, size, pixel) * (camera.distance - distance);
  camera.target += camera_axes(camera).transpose() * Vec3d(seen.x(), seen.y(), 0);
  camera.distance = distance;
  return camera;
}

Camera with_target_as_deep_as(Camera camera, const Vec3d& point) {
  const Vec3d back = camera_axes(camera).row(2);
  const Vec3d eye = camera.target + camera.distance * back;
  const double depth = (eye - point).dot(back);
  if (camera.orthographic) {
    camera.target += (camera.distance - depth) * back;
    return camera;
  }
  if (depth <= 0) return camera;
  camera.target = eye - depth * back;
  camera.distance = depth;
  return camera;
}

double covered_part(const Camera& camera, double diagonal) {
  return diagonal / (pixel_tangent(camera, {1, 1}) * camera.distance);
}

Camera with_depth_of(Camera camera, const Eigen::AlignedBox3d& box) {
  camera.scene_radius = 0.53 * box.diagonal().norm() + (camera.target - box.center()).norm();
  return camera;
}

}  // namespace burnish
