#include "client/scene/standard_view.h"

#include <gtest/gtest.h>

#include "client/scene/likely_up.h"

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

// A volcano of 9.8 by 14 km, 1.9 km high, as maps store it.
const Eigen::AlignedBox3d kLand(Vec3d(0, 30, 682), Vec3d(9780, 13980, 2543));

TEST(LikelyUp, IsZForLandInMetresAndYForAllElse) {
  EXPECT_EQ(likely_up(kLand, "", MeshFormat::kPly), UpAxis::kZ);
  EXPECT_EQ(likely_up(kLand, "m", MeshFormat::kObj), UpAxis::kZ);
  const Eigen::AlignedBox3d slab(Vec3d(0, 0, 0), Vec3d(1200, 900, 80));
  EXPECT_EQ(likely_up(slab, "", MeshFormat::kPly), UpAxis::kY);
  EXPECT_EQ(likely_up(slab, "mm", MeshFormat::kPly), UpAxis::kY);
  EXPECT_EQ(likely_up(slab, "m", MeshFormat::kPly), UpAxis::kZ);
  const Eigen::AlignedBox3d tower(Vec3d(0, 0, 0), Vec3d(9000, 9000, 8000));
  EXPECT_EQ(likely_up(tower, "m", MeshFormat::kPly), UpAxis::kY);
  EXPECT_EQ(likely_up({}, "m", MeshFormat::kPly), UpAxis::kY);
}

TEST(LikelyUp, IsYInGltfWhichSaysSo) {
  EXPECT_EQ(likely_up(kLand, "m", MeshFormat::kGlb), UpAxis::kY);
  EXPECT_EQ(likely_up(kLand, "m", MeshFormat::kGltf), UpAxis::kY);
}

TEST(LikelyUp, KnowsASmallFieldByTheCoordinatesOfItsMap) {
  const Vec3d corner(552'000, 5'120'000, 400);
  const Eigen::AlignedBox3d field(corner, corner + Vec3d(200, 150, 9));
  EXPECT_EQ(likely_up(field, "", MeshFormat::kPly), UpAxis::kZ);
  EXPECT_EQ(likely_up({Vec3d::Zero(), Vec3d(200, 150, 9)}, "", MeshFormat::kPly), UpAxis::kY);
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
