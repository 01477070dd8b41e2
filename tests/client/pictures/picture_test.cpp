#include "client/pictures/picture.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{400, 300};

int brightness(const Image& image, int x, int y) {
  const uint8_t* rgb = image.pixel(x, y);
  return rgb[0] + rgb[1] + rgb[2];
}

TEST(Picture, FramesTheWholeMesh) {
  PictureOptions options;
  options.size = kSize;
  const Image image = std::move(draw_picture(make_test_sphere(Vec3d(7, 8, 9), 3), options)).value();
  EXPECT_EQ(image.size, kSize);
  const auto differs_from_left_edge = [&](int x, int y) {
    return std::abs(brightness(image, x, y) - brightness(image, 0, y)) > 6;
  };
  EXPECT_TRUE(differs_from_left_edge(kSize.width / 2, kSize.height / 2));
  for (int x = 0; x < kSize.width; ++x) {
    EXPECT_FALSE(differs_from_left_edge(x, 0));
    EXPECT_FALSE(differs_from_left_edge(x, kSize.height - 1));
  }
}

TEST(Picture, AbsurdSizesAreRefused) {
  PictureOptions options;
  options.size = {15, 100};
  EXPECT_EQ(draw_picture(make_test_sphere(Vec3d::Zero(), 1), options).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace burnish
