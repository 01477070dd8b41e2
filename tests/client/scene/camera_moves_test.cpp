#include <gtest/gtest.h>

#include "client/scene/camera.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{640, 480};

Camera some_camera() {
  Camera camera;
  camera.target = Vec3d(1, 2, 3);
  camera.distance = 4;
  camera.azimuth_degrees = 35;
  camera.elevation_degrees = -20;
  return camera;
}

Vec3d point_at_target_depth(const Camera& camera, const Eigen::Vector2d& pixel) {
  const Ray ray = pixel_ray(camera, kSize, pixel);
  const Vec3d back = camera_axes(camera).row(2).transpose();
  return ray.origin + ray.direction * (camera.distance / -ray.direction.dot(back));
}

TEST(CameraMoves, ARayThroughAPixelMeetsWhatIsSeenThere) {
  const Camera camera = some_camera();
  const Vec3d point(1.3, 2.2, 2.5);
  const Ray ray = pixel_ray(camera, kSize, pixel_of(camera, kSize, point));
  EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-12);
  EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
}

TEST(CameraMoves, ZoomingKeepsWhatIsUnderTheCursor) {
  const Camera camera = some_camera();
  const Eigen::Vector2d cursor(500, 100);
  const Vec3d point = point_at_target_depth(camera, cursor);
  const Camera nearer = zoomed_at(camera, kSize, cursor, 0.5);
  EXPECT_DOUBLE_EQ(nearer.distance, 2);
  EXPECT_LT((pixel_of(nearer, kSize, point) - cursor).norm(), 1e-9);
}

TEST(CameraMoves, PanningMovesTheTargetsDepthWithTheCursor) {
  const Camera camera = some_camera();
  const Eigen::Vector2d from(300, 200), by(40, -25);
  const Vec3d point = point_at_target_depth(camera, from);
  EXPECT_LT((pixel_of(panned(camera, kSize, by), kSize, point) - from - by).norm(), 1e-9);
}

TEST(CameraMoves, TurningKeepsTheTargetAndStopsAtThePoles) {
  const Camera turned_camera = turned(some_camera(), 20, 500);
  EXPECT_EQ(turned_camera.target, some_camera().target);
  EXPECT_EQ(turned_camera.elevation_degrees, 90);
  EXPECT_DOUBLE_EQ(turned_camera.azimuth_degrees, 55);
}

TEST(CameraMoves, ZoomStopsBeforeTheEyeMeetsTheTarget) {
  Camera camera = some_camera();
  for (int i = 0; i < 1000; ++i) camera = zoomed_at(camera, kSize, {1, 1}, 0.5);
  EXPECT_GT(camera.distance, 0);
  for (int i = 0; i < 1000; ++i) camera = zoomed_at(camera, kSize, {1, 1}, 2);
  EXPECT_LT(camera.distance, 1e4);
}

TEST(CameraMoves, ATargetAsDeepAsAPointKeepsThePicture) {
  const Camera camera = some_camera();
  const Vec3d point = camera.target + 0.3 * camera_axes(camera).row(2).transpose() +
                      0.2 * camera_axes(camera).row(0).transpose();
  const Camera deep = with_target_as_deep_as(camera, point);
  EXPECT_NEAR(deep.distance, camera.distance - 0.3, 1e-12);
  EXPECT_LT((pixel_of(deep, kSize, point) - pixel_of(camera, kSize, point)).norm(), 1e-9);
  const Vec3d behind = camera.target + 9 * camera.distance * camera_axes(camera).row(2).transpose();
  EXPECT_EQ(with_target_as_deep_as(camera, behind), camera);
}

TEST(CameraMoves, TheDepthRangeHoldsTheBoxAfterAPan) {
  const Eigen::AlignedBox3d box(Vec3d(0, 0, 0), Vec3d(1, 1, 1));
  Camera camera = some_camera();
  camera.target = Vec3d(10, 0, 0);
  camera = with_depth_of(camera, box);
  EXPECT_GE(camera.scene_radius, (camera.target - box.min()).norm() - box.diagonal().norm() * 0.5);
  EXPECT_GE(camera.scene_radius, (camera.target - Vec3d(0, 1, 1)).norm() * 0.9);
}

}  // namespace
}  // namespace burnish
