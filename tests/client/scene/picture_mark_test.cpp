#include "client/scene/picture_mark.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr uint8_t kGrey = 120;

Image grey(int width, int height) {
  return {{width, height}, std::vector<uint8_t>(size_t{3} * width * height, kGrey)};
}

bool is_marked(const Image& image, int x, int y) {
  return image.pixel(x, y)[0] != kGrey;
}

int bright_pixels(const Image& image) {
  int count = 0;
  for (size_t i = 0; i < image.rgb.size(); i += 3) count += image.rgb[i] > kGrey;
  return count;
}

TEST(PictureMark, WordsStandInTheLowerLeftCornerAlone) {
  Image image = grey(400, 300);
  mark_picture(image, "simplified, 40 %");
  EXPECT_EQ(image.note, "simplified, 40 %");
  EXPECT_TRUE(is_marked(image, 0, 299));
  EXPECT_GT(bright_pixels(image), 100);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) {
      if (x < 110 && y >= 280) continue;
      ASSERT_FALSE(is_marked(image, x, y)) << x << " " << y;
    }
}

TEST(PictureMark, EachLetterHasAShapeOfItsOwn) {
  std::vector<Image> seen;
  for (const char letter :
       std::string("%,.+-/?'\"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")) {
    Image image = grey(16, 16);
    mark_picture(image, std::string(1, letter));
    EXPECT_GT(bright_pixels(image), 0) << letter;
    for (const Image& other : seen) EXPECT_NE(image.rgb, other.rgb) << letter;
    seen.push_back(std::move(image));
  }
}

TEST(PictureMark, WordsGrowWithThePictureAsFarAsTheyFit) {
  const auto ink_in = [](int width, int height) {
    Image image = grey(width, height);
    mark_picture(image, "simplified, 40 %");
    return bright_pixels(image);
  };
  const int small = ink_in(400, 300);
  EXPECT_EQ(ink_in(1200, 900), 4 * small);
  EXPECT_EQ(ink_in(150, 900), small);
  EXPECT_GT(ink_in(16, 16), 0);
}

constexpr ScaleBar kBar{20, 120, 1};

TEST(PictureMark, AScaleBarOfItsLengthStandsInTheLowerRightCornerAlone) {
  Image image = grey(400, 700);
  draw_scale_bar(image, kBar, "20 mm");
  EXPECT_EQ(image.note, "");
  EXPECT_TRUE(is_marked(image, 399, 699));
  int longest = 0;
  for (int y = 0; y < 700; ++y) {
    int bright = 0;
    for (int x = 0; x < 400; ++x) {
      bright += image.pixel(x, y)[0] > kGrey;
      ASSERT_TRUE((x >= 268 && y >= 662) || !is_marked(image, x, y)) << x << " " << y;
    }
    longest = std::max(longest, bright);
  }
  EXPECT_EQ(longest, 120);
}

TEST(PictureMark, AScaleBarLiesOverANoteThatReachesItAndBesideAShortOne) {
  Image wide = grey(400, 300), narrow = grey(150, 300);
  for (Image* const image : {&wide, &narrow}) {
    mark_picture(*image, "simplified, 40 %");
    draw_scale_bar(*image, {20, 60, 0.5}, "20 mm");
  }
  Image noted = grey(150, 300);
  mark_picture(noted, "simplified, 40 %");
  for (int y = 290; y < 300; ++y)
    for (int x = 0; x < 150; ++x) ASSERT_EQ(narrow.pixel(x, y)[0], noted.pixel(x, y)[0]);
  EXPECT_TRUE(is_marked(narrow, 149, 280));
  EXPECT_TRUE(is_marked(wide, 399, 299));
}

TEST(PictureMark, MicroIsALetterAndOthersBeyondAsciiAreAsked) {
  const auto drawn = [](const std::string& words) {
    Image image = grey(200, 100);
    draw_scale_bar(image, {5, 40, 0.5}, words);
    return image.rgb;
  };
  EXPECT_EQ(drawn("5 \u00b5m"), drawn("5 \u03bcm"));
  EXPECT_NE(drawn("5 \u00b5m"), drawn("5 um"));
  EXPECT_EQ(drawn("5 \u5c3a"), drawn("5 ?"));
}

TEST(PictureMark, AScaleBarHasRoomInTheSmallestPicture) {
  Image image = grey(16, 16);
  draw_scale_bar(image, {1e-5, 8, 0.5}, "0.00001 furlongs");
  EXPECT_GT(bright_pixels(image), 0);
}

}  // namespace
}  // namespace burnish
