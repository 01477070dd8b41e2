#include "client/tools/mirror_plane.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(MirrorPlane, APointAndItsImageAreAsFarFromThePlane) {
  EXPECT_EQ(mirrored(Vec3d(1, 2, 3), {0, 4}), Vec3d(7, 2, 3));
  EXPECT_EQ(mirrored(Vec3d(1, 2, 3), {2, 0}), Vec3d(1, 2, -3));
}

TEST(MirrorPlane, TwoMirrorsReturnTheStroke) {
  const MirrorPlane plane{1, 0.5};
  const Stroke stroke{{.radius = 2, .strength = 0.5, .beta = 3}, {Vec3d(1, 2, 3), Vec3d(0, 1, 0)}};
  const Stroke image = mirrored(stroke, plane);
  EXPECT_EQ(image.brush.radius, 2);
  EXPECT_EQ(image.brush.beta, 3);
  EXPECT_EQ(image.path, (std::vector<Vec3d>{Vec3d(1, -1, 3), Vec3d(0, 0, 0)}));
  EXPECT_EQ(mirrored(image, plane).path, stroke.path);
}

TEST(MirrorPlane, AxesHaveOneLetter) {
  EXPECT_EQ(*parse_axis("y"), 1);
  EXPECT_FALSE(parse_axis("w").is_ok());
  EXPECT_FALSE(parse_axis("xy").is_ok());
  EXPECT_FALSE(parse_axis("").is_ok());
}

}  // namespace
}  // namespace burnish
