#include "client/scene/ray_box.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

const Eigen::AlignedBox3d kBox(Vec3d(1, 2, 3), Vec3d(2, 4, 6));

TEST(RayBox, ARayFromOutsideMeetsTheNearSideAndOneFromInsideBeginsThere) {
  EXPECT_NEAR(distance_to_box({{-4, 3, 4}, {1, 0, 0}}, kBox).value(), 5, 1e-6);
  EXPECT_NEAR(distance_to_box({{1.5, 3, 10}, {0, 0, -1}}, kBox).value(), 4, 1e-6);
  EXPECT_EQ(distance_to_box({{1.5, 3, 4}, {0, 1, 0}}, kBox).value(), 0);
  const Vec3d diagonal = Vec3d::Ones().normalized();
  EXPECT_NEAR(distance_to_box({{0, 1, 2}, diagonal}, kBox).value(), std::sqrt(3), 1e-6);
}

TEST(RayBox, RaysBesideOrAwayFromTheBoxMissIt) {
  EXPECT_FALSE(distance_to_box({{-4, 3, 4}, {-1, 0, 0}}, kBox));
  EXPECT_FALSE(distance_to_box({{-4, 4.1, 4}, {1, 0, 0}}, kBox));
  EXPECT_FALSE(distance_to_box({{-4, 3, 7}, Vec3d(1, 0.1, 0).normalized()}, kBox));
  EXPECT_FALSE(distance_to_box({{0, 0, 0}, {1, 0, 0}}, Eigen::AlignedBox3d()));
}

TEST(RayBox, ABoxWithoutThicknessIsMetAtItsEdges) {
  const Eigen::AlignedBox3d flat(Vec3d(0, 0, 1), Vec3d(1, 1, 1));
  for (const double x : {0.0, 0.3, 1.0})
    EXPECT_NEAR(distance_to_box({{x, 1, 5}, {0, 0, -1}}, flat).value(), 4, 1e-6);
  EXPECT_TRUE(distance_to_box({{-5, 0.5, 1}, {1, 0, 0}}, flat));
}

}  // namespace
}  // namespace burnish
