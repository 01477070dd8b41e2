#include "client/scene/camera.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

Vec3d project(const Camera& camera, const Vec3d& point, double aspect) {
  const Eigen::Vector4d clip =
      projection_matrix(camera, aspect) * view_matrix(camera) * point.homogeneous();
  return clip.hnormalized();
}

TEST(Camera, AxesAreARotation) {
  Camera camera;
  camera.azimuth_degrees = 130;
  camera.elevation_degrees = -35;
  const Eigen::Matrix3d axes = camera_axes(camera);
  EXPECT_TRUE((axes * axes.transpose()).isIdentity(1e-14));
  EXPECT_NEAR(axes.determinant(), 1, 1e-14);
}

TEST(Camera, AzimuthNinetyLooksFromPlusX) {
  Camera camera;
  camera.azimuth_degrees = 90;
  EXPECT_TRUE(camera_axes(camera).row(2).transpose().isApprox(Vec3d::UnitX(), 1e-14));
}

TEST(Camera, ElevationNinetyLooksFromAbove) {
  Camera camera;
  camera.elevation_degrees = 90;
  EXPECT_TRUE(camera_axes(camera).row(2).transpose().isApprox(Vec3d::UnitY(), 1e-14));
}

TEST(Camera, ProjectsItsTargetToTheMiddle) {
  Camera camera;
  camera.target = Vec3d(3, -4, 5);
  camera.azimuth_degrees = 20;
  camera.distance = 7;
  EXPECT_NEAR(project(camera, camera.target, 1.5).head<2>().norm(), 0, 1e-14);
}

TEST(Camera, FrameAllShowsEveryCornerAndWastesLittle) {
  const Eigen::AlignedBox3d box(Vec3d(100, 20, -3), Vec3d(104, 21, 6));
  for (double aspect : {0.4, 1.0, 2.5}) {
    for (double azimuth : {0.0, 25.0, 160.0}) {
      Camera camera;
      camera.azimuth_degrees = azimuth;
      camera.elevation_degrees = 20;
      camera = frame_all(camera, box, aspect);
      double outermost = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3d seen = project(
            camera, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)), aspect);
        EXPECT_LE(std::abs(seen.z()), 1);
        outermost = std::max(outermost, seen.head<2>().lpNorm<Eigen::Infinity>());
      }
      EXPECT_LE(outermost, 1);
      EXPECT_GE(outermost, 0.9);
    }
  }
}

TEST(Camera, ZoomMagnifiesThePicture) {
  Camera camera;
  camera.distance = 10;
  const Vec3d point(0.3, 0.2, 0);
  const double before = project(camera, point, 1).x();
  camera.zoom = 2;
  EXPECT_NEAR(project(camera, point, 1).x(), 2 * before, 1e-12);
}

}  // namespace
}  // namespace burnish
