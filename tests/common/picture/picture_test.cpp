#include "common/picture/picture.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/picture/picture_rows.h"
#include "tests/common/picture/encoding.h"
#include "tests/common/picture/webp_file.h"

namespace burnish {
namespace {

using testing::HasSubstr;

Result<Picture> read(const std::string& file) {
  return read_picture({reinterpret_cast<const uint8_t*>(file.data()), file.size()}, "skin");
}

Picture stripes() {
  return drawn(16, 8, [](uint32_t x, uint32_t y) {
    return Rgba8{static_cast<uint8_t>(8 * x), static_cast<uint8_t>(16 * y), 40, 255};
  });
}

/// Returns a PNG that announces other sides; the header's sum is made right.
std::string png_announcing(uint32_t width, uint32_t height) {
  std::string file = png_of(stripes());
  const auto put = [&](size_t at, uint32_t value) {
    for (int i = 0; i < 4; ++i) file[at + i] = static_cast<char>(value >> (24 - 8 * i));
  };
  put(16, width);
  put(20, height);
  uint32_t crc = 0xffffffff;
  for (size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<uint8_t>(file[i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
  }
  put(29, ~crc);
  return file;
}

TEST(Picture, PngIsReadExactly) {
  const Picture made = stripes();
  const auto picture = read(png_of(made));
  ASSERT_TRUE(picture.is_ok()) << picture.status().message();
  EXPECT_EQ(picture->width, 16u);
  EXPECT_EQ(picture->height, 8u);
  EXPECT_EQ(picture->pixels, made.pixels);
}

/// Returns how many rows are taken when `asks` are answered, and the next one is not.
int rows_until(const std::string& file, int asks, StatusCode& code) {
  int rows = 0;
  const auto begin = [](const PictureSize&) { return Status::ok(); };
  const auto take = [&](const PixelRun&) { ++rows; };
  const auto goes_on = [&] { return asks-- > 0; };
  code = read_picture_rows({reinterpret_cast<const uint8_t*>(file.data()), file.size()}, "skin",
                           {begin, take, goes_on})
             .code();
  return rows;
}

TEST(Picture, ACancelIsHeardBetweenTwoRowsAndInEachScan) {
  const Picture made = drawn(64, 64, [](uint32_t x, uint32_t y) {
    return Rgba8{static_cast<uint8_t>(x), static_cast<uint8_t>(y), 0, 255};
  });
  for (const std::string& file : {png_of(made), interlaced_png_of(made), jpeg_of(made),
                                  jpeg_of(made, true), webp_of(made), webp_of(made, false)}) {
    StatusCode code = StatusCode::kOk;
    const int all = rows_until(file, 1'000'000, code);
    EXPECT_EQ(code, StatusCode::kOk);
    for (const int asks : {0, 1, 5}) {
      EXPECT_LT(rows_until(file, asks, code), all);
      EXPECT_EQ(code, StatusCode::kCancelled) << asks;
    }
  }
}

TEST(Picture, WebpIsReadExactlyOrNearly) {
  Picture made = stripes();
  for (Rgba8& pixel : made.pixels) pixel[3] = static_cast<uint8_t>(255 - pixel[0] % 3);
  const auto picture = read(webp_of(made));
  ASSERT_TRUE(picture.is_ok()) << picture.status().message();
  EXPECT_EQ(picture->width, 16u);
  EXPECT_EQ(picture->pixels, made.pixels);
  const auto lossy = read(webp_of(made, false));
  ASSERT_TRUE(lossy.is_ok()) << lossy.status().message();
  for (size_t i = 0; i < made.pixels.size(); ++i)
    for (size_t channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(lossy->pixels[i][channel], made.pixels[i][channel], 20) << i;
}

TEST(Picture, OtherKindsAreRefusedByTheirNames) {
  for (const auto& [file, name] :
       std::map<std::string, std::string>{{std::string("II*\0....", 8), "TIFF"},
                                          {"DDS ....", "DDS"},
                                          {"GIF89a", "GIF"},
                                          {"\xabKTX 20\xbb\r\n", "KTX2"},
                                          {"BM......", "BMP"},
                                          {"RIFF....WAVE", "PNG"}}) {
    const Status status = read(file).status();
    EXPECT_EQ(status.code(), StatusCode::kUnimplemented);
    EXPECT_THAT(status.message(), HasSubstr(name));
  }
}

TEST(Picture, JpegIsReadNearly) {
  const Picture made = stripes();
  const auto picture = read(jpeg_of(made));
  ASSERT_TRUE(picture.is_ok()) << picture.status().message();
  ASSERT_EQ(picture->pixels.size(), made.pixels.size());
  for (size_t i = 0; i < made.pixels.size(); ++i)
    for (size_t channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(picture->pixels[i][channel], made.pixels[i][channel], 12) << i;
}

TEST(Picture, InterlacedPngIsReadExactly) {
  for (const uint32_t side : {1u, 3u, 5u, 8u, 21u}) {
    const Picture made = drawn(side, side + 4, [](uint32_t x, uint32_t y) {
      return Rgba8{static_cast<uint8_t>(8 * x), static_cast<uint8_t>(9 * y), 7, 200};
    });
    const auto picture = read(interlaced_png_of(made));
    ASSERT_TRUE(picture.is_ok()) << picture.status().message();
    EXPECT_EQ(picture->pixels, made.pixels) << side;
  }
}

/// Returns the memory that the decoder of a file announces, without decoding it.
uint64_t announced_bytes(const std::string& file) {
  uint64_t bytes = 0;
  const auto begin = [&](const PictureSize& size) {
    bytes = size.decoding_bytes;
    return cancelled("asked");
  };
  const auto take = [](const PixelRun&) { FAIL() << "decoded in spite of the refusal"; };
  const std::span bytes_of{reinterpret_cast<const uint8_t*>(file.data()), file.size()};
  const Status status = read_picture_rows(bytes_of, "skin", {begin, take});
  EXPECT_EQ(status.code(), StatusCode::kCancelled);
  EXPECT_THAT(status.message(), HasSubstr("skin: picture of "));
  return bytes;
}

TEST(Picture, OnlyAJpegOfSeveralScansTakesMemoryForItsPixels) {
  const Picture wide = drawn(64, 4096, [](uint32_t, uint32_t) { return Rgba8{1, 2, 3, 255}; });
  EXPECT_LT(announced_bytes(png_of(wide)), 400'000u);
  EXPECT_LT(announced_bytes(interlaced_png_of(wide)), 400'000u);
  EXPECT_LT(announced_bytes(jpeg_of(wide)), 400'000u);
  EXPECT_GT(announced_bytes(jpeg_of(wide, true)), uint64_t{64 * 4096 * 3});
  EXPECT_TRUE(read(jpeg_of(wide, true)).is_ok());
}

TEST(Picture, TooManyPixelsAreRefusedBeforeDecoding) {
  const Status status = read(png_announcing(50'000, 60'000)).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("skin: "));
  EXPECT_THAT(status.message(), HasSubstr("50000x60000"));
  EXPECT_THAT(status.message(), HasSubstr(std::to_string(1 << 24)));
}

TEST(Picture, CutPicturesAreRefused) {
  for (const std::string& file : {png_of(stripes()), jpeg_of(stripes())})
    for (size_t length = 8; length + 16 < file.size(); length += 7)
      EXPECT_EQ(read(file.substr(0, length)).status().code(), StatusCode::kInvalidArgument)
          << length;
}

TEST(Picture, OtherKindsAreUnimplemented) {
  EXPECT_EQ(read("GIF89a").status().code(), StatusCode::kUnimplemented);
  EXPECT_EQ(read("").status().code(), StatusCode::kUnimplemented);
}

}  // namespace
}  // namespace burnish
