#include "client/scene/standard_view.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

Vec3d axis_of(UpAxis up) {
  const int number = static_cast<int>(up);
  return (number < 3 ? 1 : -1) * Vec3d::Unit(number % 3);
}

TEST(UpAxis, PointsUpInThePictureAndTheTurntableIsARotation) {
  for (int i = 0; i < kUpAxes; ++i) {
    const auto up = static_cast<UpAxis>(i);
    Camera camera;
    camera.up = up;
    camera.azimuth_degrees = 70;
    EXPECT_TRUE(camera_axes(camera).row(1).transpose().isApprox(axis_of(up), 1e-14)) << i;
    EXPECT_NEAR(to_turntable(up).determinant(), 1, 1e-14) << i;
  }
}

TEST(UpAxis, IsFoundByItsName) {
  for (int i = 0; i < kUpAxes; ++i)
    EXPECT_EQ(*parse_up_axis(name_of(static_cast<UpAxis>(i))), static_cast<UpAxis>(i));
  EXPECT_EQ(parse_up_axis("w").status().code(), StatusCode::kInvalidArgument);
}

TEST(StandardView, SixViewsLookAlongTheAxes) {
  const Vec3d eyes[] = {Vec3d::UnitZ(),  -Vec3d::UnitZ(), Vec3d::UnitX(),
                        -Vec3d::UnitX(), Vec3d::UnitY(),  -Vec3d::UnitY()};  // as StandardView
  for (int i = 0; i < kStandardViews; ++i) {
    const Camera camera = seen_from({}, static_cast<StandardView>(i));
    EXPECT_TRUE(camera_axes(camera).row(2).transpose().isApprox(eyes[i], 1e-14)) << i;
    EXPECT_EQ(*parse_standard_view(name_of(static_cast<StandardView>(i))),
              static_cast<StandardView>(i));
  }
}

TEST(StandardView, TheTopIsSeenAlongTheUpAxis) {
  Camera camera;
  camera.up = UpAxis::kZ;
  const Camera top = seen_from(camera, StandardView::kTop);
  EXPECT_TRUE(camera_axes(top).row(2).transpose().isApprox(Vec3d::UnitZ(), 1e-14));
  const Camera front = seen_from(camera, StandardView::kFront);
  EXPECT_TRUE(camera_axes(front).row(2).transpose().isApprox(-Vec3d::UnitY(), 1e-14));
}

}  // namespace
}  // namespace burnish
