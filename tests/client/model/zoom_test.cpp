#include "client/model/view/zoom.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr ImageSize kSize{640, 480};
const Eigen::AlignedBox3d kBox(Vec3d(-1, -1, -1), Vec3d(1, 1, 1));
const Eigen::Vector2d kCorner(20, 20);

Camera home() {
  return frame_all({.azimuth_degrees = 25, .elevation_degrees = 20}, kBox, kSize.aspect());
}

Vec3d eye_of(const Camera& camera) {
  return camera.target + camera.distance * camera_axes(camera).row(2).transpose();
}

TEST(Zoom, AHundredStepsTowardsASurfaceEndBeforeIt) {
  Camera camera = home();
  const Vec3d point(0.2, 0.3, 0.9);
  const Eigen::Vector2d pixel = pixel_of(camera, kSize, point);
  for (int i = 0; i < 100; ++i) camera = zoomed_by_wheel(camera, kSize, {pixel, point}, 1, kBox);
  EXPECT_GT((eye_of(camera) - point).dot(camera_axes(camera).row(2)), 0);
  EXPECT_LT((eye_of(camera) - point).norm(), 0.01);
  EXPECT_LT((pixel_of(camera, kSize, point) - pixel).norm(), 1e-3);
}

TEST(Zoom, BesideTheSurfaceTheEyeStaysBeforeTheScanAndTheScanInThePicture) {
  Camera camera = home();
  for (int i = 0; i < 200; ++i) camera = zoomed_by_wheel(camera, kSize, {kCorner, {}}, 1, kBox);
  EXPECT_GT(kBox.exteriorDistance(eye_of(camera)), 0);
  const Eigen::Vector2d middle = pixel_of(camera, kSize, kBox.center());
  EXPECT_GE(middle.minCoeff(), 0);
  EXPECT_LE(middle.x(), kSize.width);
  EXPECT_LE(middle.y(), kSize.height);
}

TEST(Zoom, AwayFromTheScanItsDiagonalKeepsATenthOfTheHeight) {
  Camera camera = home();
  for (int i = 0; i < 300; ++i) camera = zoomed_by_wheel(camera, kSize, {kCorner, {}}, -1, kBox);
  EXPECT_NEAR(covered_part(camera, kBox.diagonal().norm()), 0.1, 1e-9);
}

TEST(Zoom, WithoutPerspectiveTheSameLimitsHold) {
  Camera camera = home();
  camera.orthographic = true;
  for (int i = 0; i < 300; ++i) camera = zoomed_by_wheel(camera, kSize, {kCorner, {}}, -1, kBox);
  EXPECT_NEAR(covered_part(camera, kBox.diagonal().norm()), 0.1, 1e-9);
  for (int i = 0; i < 300; ++i) camera = zoomed_by_wheel(camera, kSize, {{320, 240}, {}}, 1, kBox);
  EXPECT_GT(camera.distance, 0.02 * kBox.diagonal().norm());
}

TEST(Zoom, AStepBackUndoesAStepNearer) {
  const Camera from = home();
  const Camera nearer = zoomed_by_wheel(from, kSize, {kCorner, Vec3d(0, 0, 1)}, 1, kBox);
  const Camera back = zoomed_by_wheel(nearer, kSize, {kCorner, Vec3d(0, 0, 1)}, -1, kBox);
  EXPECT_LT((eye_of(back) - eye_of(from)).norm(), 1e-9);
}

}  // namespace
}  // namespace burnish
