#include "server/prepare/sheets/picture_tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/prepare/sheets/picture_sampler.h"
#include "tests/common/picture/encoding.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/sheets/painted_ball.h"

namespace burnish {
namespace {

/// Returns a picture in which each texel differs.
Picture numbered(uint32_t width, uint32_t height) {
  return drawn(width, height, [](uint32_t x, uint32_t y) {
    return Rgba8{static_cast<uint8_t>(x), static_cast<uint8_t>(y),
                 static_cast<uint8_t>(x / 256 + y / 256 * 16), 255};
  });
}

class PictureTilesOfFile : public testing::Test {
 protected:
  Status decode(const std::string& file) {
    return tiles_.decode(
        0, bytes_of(file), "picture", [](const PictureSize&) { return Status::ok(); },
        [] { return true; });
  }
  Rgba8 at(double x, double y, const TextureWraps& wraps = {}) {
    PictureSampler sampler(tiles_);
    const Texel texel = sampler.sample(tiles_.levels(0).front(), x + 0.5, y + 0.5, wraps);
    EXPECT_TRUE(sampler.status().is_ok());
    return {static_cast<uint8_t>(texel[0]), static_cast<uint8_t>(texel[1]),
            static_cast<uint8_t>(texel[2]), static_cast<uint8_t>(texel[3])};
  }
  void expect_all(const Picture& picture) {
    PictureSampler sampler(tiles_);
    for (uint32_t y = 0; y < picture.height; ++y)
      for (uint32_t x = 0; x < picture.width; ++x) {
        const Texel texel = sampler.sample(tiles_.levels(0).front(), x + 0.5, y + 0.5, {});
        for (int i = 0; i < 4; ++i) ASSERT_EQ(texel[i], picture.at(x, y)[i]) << x << ' ' << y;
      }
  }

  TemporaryFolder folder_;
  PictureTiles tiles_ = PictureTiles::create(folder_.path(), 1).value();
};

TEST_F(PictureTilesOfFile, EveryTexelComesBack) {
  const Picture picture = numbered(300, 130);
  ASSERT_TRUE(decode(png_of(picture)).is_ok());
  expect_all(picture);
}

TEST_F(PictureTilesOfFile, EveryTexelOfAnInterlacedOneComesBack) {
  const Picture picture = numbered(130, 300);
  ASSERT_TRUE(decode(interlaced_png_of(picture)).is_ok());
  expect_all(picture);
}

TEST_F(PictureTilesOfFile, ALowOneTakesNoMoreThanItsRows) {
  const Picture picture = numbered(300, 2);
  ASSERT_TRUE(decode(png_of(picture)).is_ok());
  expect_all(picture);
  EXPECT_EQ(tiles_.levels(0)[0].band_bytes(), 320u * 2 * 4);
}

TEST_F(PictureTilesOfFile, GoesOnBeyondItsBordersAsTheWrapSays) {
  const Picture picture = numbered(100, 50);
  ASSERT_TRUE(decode(png_of(picture)).is_ok());
  EXPECT_EQ(at(-1 - 500, 7), picture.at(99, 7));
  const TextureWraps mirror = {TextureWrap::kMirror, TextureWrap::kMirror};
  EXPECT_EQ(at(103, 52, mirror), picture.at(96, 47));
  const TextureWraps clamp = {TextureWrap::kClamp, TextureWrap::kClamp};
  EXPECT_EQ(at(-40, 70, clamp), picture.at(0, 49));
}

TEST_F(PictureTilesOfFile, EachLevelHasTheMeansOfTheFinerOne) {
  const Picture picture = drawn(200, 130, [](uint32_t x, uint32_t y) {
    return Rgba8{static_cast<uint8_t>(x), static_cast<uint8_t>(y), 7, 255};
  });
  ASSERT_TRUE(decode(png_of(picture)).is_ok());
  const auto levels = tiles_.levels(0);
  ASSERT_EQ(levels.size(), 8u);
  EXPECT_EQ(levels.back().width, 1u);
  EXPECT_EQ(levels.back().height, 1u);
  PictureSampler sampler(tiles_);
  const Texel quarter = sampler.sample(levels[2], 20.5, 30.5, {});  // of 80..83 and 120..123
  EXPECT_NEAR(quarter[0], 81.5, 1);
  EXPECT_NEAR(quarter[1], 121.5, 1);
  EXPECT_EQ(quarter[2], 7);
}

TEST_F(PictureTilesOfFile, TexelsThatDoNotComeAreWhite) {
  const Picture picture = drawn(400, 400, [](uint32_t x, uint32_t y) {  // hard to compress
    const uint32_t noise = (x * 2654435761u) ^ (y * 2246822519u);
    return Rgba8{static_cast<uint8_t>(noise >> 24), static_cast<uint8_t>(noise >> 16),
                 static_cast<uint8_t>(noise >> 8), 255};
  });
  std::string file = png_of(picture);
  file.resize(file.size() / 2);
  EXPECT_EQ(decode(file).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(at(50, 0), picture.at(50, 0));
  EXPECT_EQ(at(50, 399), (Rgba8{255, 255, 255, 255}));
}

TEST_F(PictureTilesOfFile, AnotherKindOfFileHasNoTexels) {
  EXPECT_EQ(decode("GIF89a").code(), StatusCode::kUnimplemented);
  EXPECT_FALSE(tiles_.has(0));
}

}  // namespace
}  // namespace burnish
