#include "client/tools/lasso.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using Eigen::Vector2d;

TEST(Lasso, HasThePointsOfThePictureInTheViewOfItsCamera) {
  const Camera camera = frame_all({.azimuth_degrees = 30}, {Vec3d(0, 0, 0), Vec3d(1, 2, 3)}, 2);
  const ImageSize size{400, 200};
  const LassoRegion lasso =
      lasso_in_picture(camera, size, {Vector2d(0, 0), Vector2d(400, 200), Vector2d(200, 0)}, true);
  ASSERT_EQ(lasso.polygon.size(), 3u);
  EXPECT_EQ(lasso.polygon[0], Vector2d(-1, 1));
  EXPECT_EQ(lasso.polygon[1], Vector2d(1, -1));
  EXPECT_TRUE(lasso.through);
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> rows(
      lasso.view_projection.data());
  const Vec3d point(0.3, 1.2, 2);
  const Eigen::Vector4d clip = rows * point.homogeneous();
  const Vector2d pixel = pixel_of(camera, size, point);
  EXPECT_NEAR(clip.x() / clip.w(), 2 * pixel.x() / 400 - 1, 1e-9);
  EXPECT_NEAR(clip.y() / clip.w(), 1 - 2 * pixel.y() / 200, 1e-9);
}

TEST(Lasso, ALongLineIsThinnedOut) {
  std::vector<Vector2d> pixels;
  for (int i = 0; i < 5000; ++i) pixels.emplace_back(i, i % 7);
  const LassoRegion lasso = lasso_in_picture({}, {5000, 10}, pixels, false);
  EXPECT_EQ(lasso.polygon.size(), kLassoPointsMax);
  EXPECT_LT(lasso.polygon.front().x(), -0.99);
  EXPECT_GT(lasso.polygon.back().x(), 0.99);
}

}  // namespace
}  // namespace burnish
