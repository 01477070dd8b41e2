#include "client/scene/image.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Image, ASizeIsTwoWholeNumbersWithACrossBetween) {
  const Result<ImageSize> size = parse_image_size("1280x960");
  ASSERT_TRUE(size.is_ok()) << size.status().message();
  EXPECT_EQ(*size, (ImageSize{1280, 960}));
}

TEST(Image, WhatIsNoSizeIsNamed) {
  for (const char* const text : {"", "x", "1280", "1280x", "x960", "1280x960x", "1280x960 px",
                                 "12.5x960", "1280X960", "99999999999x960"}) {
    const Result<ImageSize> size = parse_image_size(text);
    ASSERT_FALSE(size.is_ok()) << text;
    EXPECT_EQ(size.status().message(),
              "'" + std::string(text) + "' is not WIDTHxHEIGHT in pixels, such as 1280x960");
  }
}

TEST(Image, ASideBeyondTheLimitIsRefusedWithTheLimit) {
  const Result<ImageSize> size = parse_image_size("1280x8193");
  ASSERT_FALSE(size.is_ok());
  EXPECT_EQ(size.status().message(),
            "picture of 1280x8193 pixels: both sides must be within 16..8192");
}

}  // namespace
}  // namespace burnish
