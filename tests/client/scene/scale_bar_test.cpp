#include "client/scene/scale_bar.h"

#include <cmath>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr ImageSize kPicture{800, 600};

Camera camera_at(double distance) {
  Camera camera;
  camera.distance = distance;
  return camera;
}

TEST(ScaleBar, IsARoundLengthOfAsManyPixelsAsThePictureShowsThereAtAnyDistance) {
  for (const bool orthographic : {false, true})
    for (double distance = 1e-4; distance < 1e7; distance *= 1.7) {
      Camera camera = camera_at(distance);
      camera.orthographic = orthographic;
      const auto bar = scale_bar(camera, kPicture, 1);
      ASSERT_TRUE(bar.has_value());
      EXPECT_GT(bar->pixels, 71.9) << distance;
      EXPECT_LE(bar->pixels, 180 * (1 + 1e-12)) << distance;
      const Vec3d end = camera.target + bar->length * camera_axes(camera).row(0).transpose();
      const double shown =
          (pixel_of(camera, kPicture, end) - pixel_of(camera, kPicture, camera.target)).norm();
      EXPECT_NEAR(shown, bar->pixels, 1e-6) << distance;
    }
}

TEST(ScaleBar, HasAWholeMillimetreWhereOneFits) {
  Camera camera = camera_at(0);
  camera.distance = 100 / pixel_length(camera_at(1), kPicture);  // a pixel is 100 long
  EXPECT_NEAR(scale_bar(camera, kPicture, 1)->length, 10'000, 1e-9);
  EXPECT_NEAR(scale_bar(camera, kPicture, 1)->pixels, 100, 1e-9);
}

TEST(ScaleBar, IsAsLongForTheEyeOnAScreenOfSmallPixels) {
  const auto plain = scale_bar(camera_at(3), kPicture, 1);
  const auto fine = scale_bar(camera_at(3), {1600, 1200}, 2);
  EXPECT_EQ(plain->length, fine->length);
  EXPECT_NEAR(2 * plain->pixels, fine->pixels, 1e-9);
}

TEST(ScaleBar, LeavesHalfOfANarrowPictureFree) {
  for (int width : {16, 60, 200})
    EXPECT_LE(scale_bar(camera_at(2), {width, 600}, 1)->pixels, width / 2);
}

TEST(ScaleBar, IsNotThereWithoutADistance) {
  EXPECT_FALSE(scale_bar(camera_at(0), kPicture, 1).has_value());
  EXPECT_FALSE(scale_bar(camera_at(std::nan("")), kPicture, 1).has_value());
}

TEST(ScaleBar, GrowsWithAPictureThatIsForNoScreen) {
  EXPECT_EQ(pixel_ratio_of({300, 200}), 0.5);
  EXPECT_EQ(pixel_ratio_of({1280, 700}), 1);
  EXPECT_EQ(pixel_ratio_of({4000, 2800}), 4);
}

}  // namespace
}  // namespace burnish
