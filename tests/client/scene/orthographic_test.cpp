#include <gtest/gtest.h>

#include "client/scene/camera.h"

namespace burnish {
namespace {

constexpr ImageSize kParallelSize{640, 480};

Camera parallel_camera() {
  Camera camera;
  camera.target = Vec3d(1, 2, 3);
  camera.distance = 4;
  camera.azimuth_degrees = 35;
  camera.elevation_degrees = -20;
  camera.scene_radius = 6;
  camera.orthographic = true;
  return camera;
}

Eigen::Vector2d by_matrices(const Camera& camera, const Vec3d& point) {
  const Vec3d clip = (projection_matrix(camera, kParallelSize.aspect()) * view_matrix(camera) *
                      point.homogeneous())
                         .hnormalized();
  return {0.5 * kParallelSize.width * (1 + clip.x()), 0.5 * kParallelSize.height * (1 - clip.y())};
}

TEST(Orthographic, EqualLengthsAreEqualAtEveryDepth) {
  const Camera camera = parallel_camera();
  const Vec3d right = camera_axes(camera).row(0), back = camera_axes(camera).row(2);
  const auto pixels_at = [&](double depth) {
    const Vec3d from = camera.target + depth * back;
    return (pixel_of(camera, kParallelSize, from + right) - pixel_of(camera, kParallelSize, from))
        .norm();
  };
  EXPECT_NEAR(pixels_at(-5), pixels_at(0), 1e-9);
  EXPECT_NEAR(pixels_at(5), 1 / pixel_length(camera, kParallelSize), 1e-9);
}

TEST(Orthographic, PixelsAreThoseOfTheMatrices) {
  const Camera camera = parallel_camera();
  for (const Vec3d& point : {Vec3d(1.3, 2.2, 2.5), Vec3d(-1, 0, 4), Vec3d(3, 3, 3)})
    EXPECT_LT((pixel_of(camera, kParallelSize, point) - by_matrices(camera, point)).norm(), 1e-9);
}

TEST(Orthographic, RaysRunAlongTheViewAndBeginBeforeTheScene) {
  const Camera camera = parallel_camera();
  const Vec3d back = camera_axes(camera).row(2);
  const Vec3d point = camera.target + 5.9 * back + 0.3 * camera_axes(camera).row(1).transpose();
  const Ray ray = pixel_ray(camera, kParallelSize, pixel_of(camera, kParallelSize, point));
  EXPECT_LT((ray.direction + back).norm(), 1e-12);
  EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-9);
  EXPECT_GT((point - ray.origin).dot(ray.direction), 0);
}

TEST(Orthographic, WhatLiesBehindTheEyeOfThePerspectiveIsInTheDepthRange) {
  const Camera camera = parallel_camera();
  const Vec3d behind = camera.target + 5 * camera_axes(camera).row(2).transpose();
  const Vec3d clip =
      (projection_matrix(camera, 1) * view_matrix(camera) * behind.homogeneous()).hnormalized();
  EXPECT_GT(clip.z(), -1);
  EXPECT_LT(clip.z(), 0);
}

TEST(Orthographic, TheTargetKeepsItsScaleWhenPerspectiveGoes) {
  Camera camera = parallel_camera();
  const double length = pixel_length(camera, kParallelSize);
  camera.orthographic = false;
  EXPECT_DOUBLE_EQ(pixel_length(camera, kParallelSize), length);
}

TEST(Orthographic, ZoomingKeepsWhatIsUnderTheCursorAtAnyDepth) {
  const Camera camera = parallel_camera();
  const Eigen::Vector2d cursor(500, 100);
  const Ray ray = pixel_ray(camera, kParallelSize, cursor);
  const Vec3d point = ray.origin + 3 * ray.direction;
  const Camera nearer =
      zoomed_at(with_target_as_deep_as(camera, point), kParallelSize, cursor, 0.5);
  EXPECT_LT((pixel_of(nearer, kParallelSize, point) - cursor).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(nearer.distance, 2);
}

TEST(Orthographic, FramingFitsTheBoxWhateverItsDepth) {
  const Eigen::AlignedBox3d box(Vec3d(-1, -1, -50), Vec3d(1, 1, 50));
  Camera camera;
  camera.orthographic = true;
  camera = frame_all(camera, box, 1);
  EXPECT_NEAR(covered_part(camera, 2), 1 / 1.06, 1e-9);
}

}  // namespace
}  // namespace burnish
