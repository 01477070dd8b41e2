#include "client/scene/axes_gizmo.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr ImageSize kPicture{800, 600};

Vec3d direction_to(const AxisEnd& end) {
  const int number = static_cast<int>(end.axis);
  return (number < 3 ? 1 : -1) * Vec3d::Unit(number % 3);
}

AxesGizmo gizmo_of(const Camera& camera) {
  return axes_gizmo(camera, kPicture, 1).value();
}

TEST(AxesGizmo, EndsLieWhereTheCameraSeesTheirDirections) {
  for (int up = 0; up < kUpAxes; ++up) {
    Camera camera;
    camera.up = static_cast<UpAxis>(up);
    camera.azimuth_degrees = 40;
    camera.elevation_degrees = 25;
    const AxesGizmo gizmo = gizmo_of(camera);
    for (const AxisEnd& end : gizmo.ends) {
      const Vec3d seen = camera_axes(camera) * direction_to(end);
      const Eigen::Vector2d way = (end.place - gizmo.middle) / 32;
      EXPECT_TRUE(way.isApprox(Eigen::Vector2d(seen.x(), -seen.y()), 1e-12)) << up;
      EXPECT_NEAR(end.depth, seen.z(), 1e-12);
    }
  }
}

TEST(AxesGizmo, TheAxisThatPointsUpInTheScanPointsUpInThePicture) {
  Camera camera;
  camera.up = UpAxis::kMinusZ;
  for (const AxisEnd& end : gizmo_of(camera).ends) {
    if (end.axis != UpAxis::kMinusZ) continue;
    EXPECT_NEAR(end.place.x(), 50, 1e-12);
    EXPECT_NEAR(end.place.y(), 18, 1e-12);
  }
}

TEST(AxesGizmo, TheViewOfAnEndBringsItBeforeTheMiddle) {
  for (int up = 0; up < kUpAxes; ++up) {
    Camera camera;
    camera.up = static_cast<UpAxis>(up);
    camera.azimuth_degrees = -70;
    for (const AxisEnd& end : gizmo_of(camera).ends) {
      const AxesGizmo then = gizmo_of(seen_from(camera, end.view));
      EXPECT_EQ(then.ends.back().axis, end.axis) << up;
      EXPECT_LT((then.ends.back().place - then.middle).norm(), 1e-9);
      EXPECT_EQ(end_at(then, then.middle)->axis, end.axis) << "and not the one behind it";
    }
  }
}

TEST(AxesGizmo, APointMeetsTheNearestEndWithinItsDiscAlone) {
  Camera camera;
  camera.azimuth_degrees = 30;
  camera.elevation_degrees = 20;
  const AxesGizmo gizmo = gizmo_of(camera);
  for (const AxisEnd& end : gizmo.ends) {
    EXPECT_EQ(end_at(gizmo, end.place)->axis, end.axis);
    EXPECT_TRUE(covers(gizmo, end.place));
  }
  EXPECT_EQ(end_at(gizmo, gizmo.middle), nullptr);
  EXPECT_TRUE(covers(gizmo, gizmo.middle));
  EXPECT_FALSE(covers(gizmo, {100, 50}));
  EXPECT_EQ(end_at(gizmo, {400, 300}), nullptr);
}

TEST(AxesGizmo, LiesWithinItsCornerAndNotOverASmallPicture) {
  const AxesGizmo fine = axes_gizmo({}, {1600, 1200}, 2).value();
  EXPECT_GE(fine.middle.minCoeff(), fine.radius);
  EXPECT_EQ(fine.radius, 2 * gizmo_of({}).radius);
  EXPECT_FALSE(axes_gizmo({}, {319, 600}, 1).has_value());
  EXPECT_FALSE(axes_gizmo({}, {800, 199}, 1).has_value());
  EXPECT_FALSE(axes_gizmo({}, {600, 600}, 2).has_value());
}

}  // namespace
}  // namespace burnish
