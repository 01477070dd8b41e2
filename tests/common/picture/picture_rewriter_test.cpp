#include "common/picture/picture_rewriter.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/picture/picture.h"
#include "tests/common/picture/encoding.h"
#include "tests/common/picture/raw_png.h"
#include "tests/common/picture/webp_file.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::span<const uint8_t> bytes_of(const std::string& file) {
  return {reinterpret_cast<const uint8_t*>(file.data()), file.size()};
}

/// The texels that a test changes.
struct Patch {
  uint32_t left, top, right, bottom;  // the last two are not in it
  int change;                         // of each channel

  bool has(uint32_t x, uint32_t y) const {
    return x >= left && x < right && y >= top && y < bottom;
  }
};
constexpr Patch kPatch = {37, 19, 45, 28, 40};

PictureEditor editor_of(const Patch& patch) {
  const auto change = [patch](const FileRows& rows) {
    for (uint32_t y = 0; y < rows.count; ++y)
      for (uint32_t x = 0; x < rows.width; ++x)
        for (uint16_t& channel : rows.texels[size_t{y} * rows.width + x])
          if (patch.has(x, rows.first + y))
            channel = static_cast<uint16_t>(
                std::min(int{rows.max}, channel + patch.change * (rows.max / 255)));
    return Status::ok();
  };
  return {[](const PictureSize&) { return Status::ok(); }, change, {}};
}

Picture soft_noise(uint32_t width = 101, uint32_t height = 150) {
  uint32_t state = 1;
  return drawn(width, height, [&](uint32_t x, uint32_t y) {
    const auto channel = [&](double phase) {
      state = 1664525 * state + 1013904223;
      const double wave = 100 + 40 * std::sin(0.11 * x + phase) * std::cos(0.07 * y);
      return static_cast<uint8_t>(wave + (state >> 24) % 16);
    };
    return Rgba8{channel(0), channel(1), channel(2), 255};
  });
}

/// Rewrites a JPEG and compares the pixels of both files.
void expect_only_the_patch_changes(const JpegStyle& style, uint32_t mcu) {
  const std::string file = jpeg_of(soft_noise(), style);
  const auto rewritten = rewrite_picture(bytes_of(file), "skin", editor_of(kPatch));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  EXPECT_EQ(rewritten->texels, 8u * 9u);
  const Picture before = read_picture(bytes_of(file), "before").value();
  const Picture after = read_picture(rewritten->bytes, "after").value();
  ASSERT_EQ(after.width, before.width);
  ASSERT_EQ(after.height, before.height);
  const auto begin = [&](uint32_t at) { return at / mcu * mcu - 1; };
  const auto end = [&](uint32_t at) { return (at + mcu - 1) / mcu * mcu + 1; };
  const Patch touched = {begin(kPatch.left), begin(kPatch.top), end(kPatch.right),
                         end(kPatch.bottom), 0};
  double wrong = 0;
  for (uint32_t y = 0; y < before.height; ++y)
    for (uint32_t x = 0; x < before.width; ++x) {
      if (!touched.has(x, y)) {
        ASSERT_EQ(after.at(x, y), before.at(x, y)) << x << " " << y;
      }
      if (kPatch.has(x, y))
        wrong = std::max(wrong, std::abs(after.at(x, y)[1] - before.at(x, y)[1] - 40.0));
    }
  EXPECT_LT(wrong, 6) << "at quality 100";
}

TEST(JpegRewriter, PixelsOutsideTheTouchedMcusAndARingStay) {
  expect_only_the_patch_changes({.sampling = 1}, 8);
  expect_only_the_patch_changes({.sampling = 2}, 16);
  expect_only_the_patch_changes({.is_grey = true}, 16);
  expect_only_the_patch_changes({.sampling = 1, .is_grey = true}, 8);
  expect_only_the_patch_changes({.is_progressive = true}, 16);
  expect_only_the_patch_changes({.is_progressive = true, .sampling = 1}, 8);
  expect_only_the_patch_changes({.restart_rows = 1}, 16);
}

TEST(JpegRewriter, MarkersAndTheKindOfFileStay) {
  const std::string file =
      jpeg_of(soft_noise(), {.is_progressive = true, .comment = "made by hand"});
  const auto rewritten = rewrite_picture(bytes_of(file + "and more"), "skin", editor_of(kPatch));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  const std::string after(rewritten->bytes.begin(), rewritten->bytes.end());
  EXPECT_THAT(after, HasSubstr("made by hand"));
  EXPECT_THAT(after, HasSubstr("JFIF"));
  EXPECT_THAT(after, HasSubstr("\xff\xc2")) << "a progressive file has this frame";
  EXPECT_TRUE(after.ends_with("and more"));
  EXPECT_NEAR(after.size(), file.size(), 0.02 * file.size());
}

TEST(JpegRewriter, TheQuantisationTablesOfAPoorFileStay) {
  const auto tables_of = [](const std::string& file) {
    const size_t begin = file.find("\xff\xdb");
    return file.substr(begin, 2 + 65 + 2);
  };
  const std::string file = jpeg_of(soft_noise(), {.quality = 60});
  const auto rewritten = rewrite_picture(bytes_of(file), "skin", editor_of(kPatch));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  EXPECT_EQ(tables_of({rewritten->bytes.begin(), rewritten->bytes.end()}), tables_of(file));
}

std::string cmyk_jpeg() {
  jpeg_compress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = jpeg.image_height = 8;
  jpeg.input_components = 4;
  jpeg.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<uint8_t> pixels(8 * 4, 90);
  for (JSAMPROW row = pixels.data(); jpeg.next_scanline < 8;) jpeg_write_scanlines(&jpeg, &row, 1);
  jpeg_finish_compress(&jpeg);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return file;
}

Status failure_of(const std::string& file) {
  return rewrite_picture(bytes_of(file), "skin", editor_of(kPatch)).status();
}

TEST(JpegRewriter, KindsThatItCannotWriteAreRefusedByName) {
  EXPECT_THAT(failure_of(cmyk_jpeg()).message(), HasSubstr("CMYK"));
  const std::string arithmetic = jpeg_of(soft_noise(), {.has_arithmetic_codes = true});
  EXPECT_THAT(failure_of(arithmetic).message(), HasSubstr("arithmetic"));
  std::string deep = jpeg_of(soft_noise());
  deep[deep.find("\xff\xc0") + 4] = 12;  // bits a sample
  EXPECT_THAT(failure_of(deep).message(), HasSubstr("12"));
}

TEST(WebpRewriter, OnlyTheChangedPixelsChange) {
  Picture made = soft_noise();
  for (Rgba8& pixel : made.pixels) pixel[3] = pixel[0] % 2 == 0 ? 255 : 90;
  for (const bool is_lossless : {true, false}) {
    const std::string file = webp_of(made, is_lossless);
    const auto rewritten = rewrite_picture(bytes_of(file), "skin", editor_of(kPatch));
    ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
    EXPECT_EQ(rewritten->texels, 8u * 9u);
    EXPECT_THAT(rewritten->note, HasSubstr("without loss"));
    const Picture before = read_picture(bytes_of(file), "before").value();
    const Picture after = read_picture(rewritten->bytes, "after").value();
    for (uint32_t y = 0; y < before.height; ++y)
      for (uint32_t x = 0; x < before.width; ++x) {
        Rgba8 expected = before.at(x, y);
        for (size_t i = 0; i < 3; ++i)
          if (kPatch.has(x, y))
            expected[i] = static_cast<uint8_t>(std::min(255, expected[i] + kPatch.change));
        ASSERT_EQ(after.at(x, y), expected) << x << " " << y;
      }
  }
}

TEST(WebpRewriter, ACancelIsHeardWhileItPacks) {
  const std::string file = webp_of(soft_noise());
  PictureEditor editor = editor_of(kPatch);
  int asks = 0;
  editor.goes_on = [&] { return ++asks > 0; };
  ASSERT_TRUE(rewrite_picture(bytes_of(file), "skin", editor).is_ok());
  for (int last = asks - 1; last >= 0; --last) {
    int left = last;
    editor.goes_on = [&] { return left-- > 0; };
    EXPECT_EQ(rewrite_picture(bytes_of(file), "skin", editor).status().code(),
              StatusCode::kCancelled)
        << last << " of " << asks;
  }
}

TEST(WebpRewriter, AColourProfileAndMotionAreRefusedByName) {
  const std::string plain = webp_of(soft_noise());
  const auto extended = [&](char flags) {
    std::string file = plain.substr(0, 12) + std::string("VP8X\x0a\0\0\0", 8) + flags +
                       std::string(3, '\0') + std::string("\x64\0\0\x95\0\0", 6) + plain.substr(12);
    const auto riff = static_cast<uint32_t>(file.size() - 8);
    for (size_t i = 0; i < 4; ++i) file[4 + i] = static_cast<char>(riff >> (8 * i));
    return file;
  };
  EXPECT_TRUE(rewrite_picture(bytes_of(extended(0)), "skin", editor_of(kPatch)).is_ok());
  EXPECT_THAT(failure_of(extended(0x20)).message(), HasSubstr("colour profile"));
  EXPECT_THAT(failure_of(extended(0x02)).message(), HasSubstr("animated"));
}

TEST(PictureRewriter, ATruncatedFileIsAnErrorWithItsName) {
  for (const std::string& file :
       {jpeg_of(soft_noise()), jpeg_of(soft_noise(), true), png_of(soft_noise()),
        interlaced_png_of(soft_noise()), webp_of(soft_noise()), webp_of(soft_noise(), false)})
    for (const size_t part : {2, 3, 50}) {
      const Status failure = failure_of(file.substr(0, file.size() / part));
      EXPECT_EQ(failure.code(), StatusCode::kInvalidArgument) << failure.message();
      EXPECT_THAT(failure.message(), HasSubstr("skin"));
    }
  EXPECT_THAT(failure_of("GIF89a").message(), HasSubstr("GIF is not"));
}

TEST(PictureRewriter, NothingIsWrittenWhereNothingChanges) {
  for (const std::string& file :
       {jpeg_of(soft_noise()), png_of(soft_noise()), webp_of(soft_noise())}) {
    const auto rewritten = rewrite_picture(bytes_of(file), "skin", editor_of({0, 0, 9, 9, 0}));
    ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
    EXPECT_THAT(rewritten->bytes, IsEmpty());
    EXPECT_EQ(rewritten->texels, 0u);
  }
}

TEST(PictureRewriter, MemoryIsAskedForBeforeAnythingIsDecoded) {
  for (const std::string& file :
       {jpeg_of(soft_noise()), png_of(soft_noise()), webp_of(soft_noise())}) {
    PictureEditor editor = editor_of(kPatch);
    uint64_t asked = 0;
    editor.begin = [&](const PictureSize& size) {
      asked = size.decoding_bytes;
      return resource_exhausted("too much");
    };
    editor.change = [](const FileRows&) -> Status { return internal_error("has begun"); };
    const auto rewritten = rewrite_picture(bytes_of(file), "skin", editor);
    EXPECT_EQ(rewritten.status().code(), StatusCode::kResourceExhausted);
    EXPECT_THAT(rewritten.status().message(), HasSubstr("101x150"));
    EXPECT_GT(asked, 101u * 150u * 3u);
  }
}

TEST(PictureRewriter, ACancelledRewritingEnds) {
  for (const std::string& file : {jpeg_of(soft_noise()), jpeg_of(soft_noise(), true),
                                  png_of(soft_noise()), interlaced_png_of(soft_noise())}) {
    PictureEditor editor = editor_of(kPatch);
    editor.goes_on = [] { return false; };
    EXPECT_EQ(rewrite_picture(bytes_of(file), "skin", editor).status().code(),
              StatusCode::kCancelled);
  }
}

TEST(PngRewriter, OtherPixelsStayInEveryDepthAndKindOfColour) {
  for (const int depth : {8, 16})
    for (const int kind : {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                           PNG_COLOR_TYPE_RGB_ALPHA}) {
      const RawPng before = RawPng::noise(101, 150, depth, kind);
      const auto rewritten = rewrite_picture(bytes_of(before.encoded()), "skin", editor_of(kPatch));
      ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
      const RawPng after = RawPng::decoded(rewritten->bytes);
      ASSERT_EQ(after.depth, depth);
      ASSERT_EQ(after.kind, kind);
      EXPECT_THAT(rewritten->note, IsEmpty());
      for (uint32_t y = 0; y < 150; ++y)
        for (uint32_t x = 0; x < 101; ++x)
          for (int c = 0; c < before.channels(); ++c) {
            const bool is_changed = kPatch.has(x, y) && c < before.colours();
            ASSERT_EQ(after.value(x, y, c),
                      before.value(x, y, c) + (is_changed ? 40 * before.max() / 255 : 0))
                << x << " " << y << " " << c;
          }
    }
}

TEST(PngRewriter, APaletteBecomesRgbWithTheSameColours) {
  const RawPng before = RawPng::noise(101, 150, 4, PNG_COLOR_TYPE_PALETTE);
  const std::string file = before.encoded();
  const auto rewritten = rewrite_picture(bytes_of(file), "skin", editor_of(kPatch));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  EXPECT_THAT(rewritten->note, HasSubstr("8 bits"));
  const Picture was = read_picture(bytes_of(file), "before").value();
  const Picture is = read_picture(rewritten->bytes, "after").value();
  for (uint32_t y = 0; y < 150; ++y)
    for (uint32_t x = 0; x < 101; ++x) {
      if (!kPatch.has(x, y)) {
        ASSERT_EQ(is.at(x, y), was.at(x, y));
      }
    }
  EXPECT_EQ(is.at(40, 20)[0], was.at(40, 20)[0] + 40);
}

TEST(PngRewriter, FewGreysBecomeEightBits) {
  const RawPng before = RawPng::noise(101, 150, 2, PNG_COLOR_TYPE_GRAY);
  const auto rewritten = rewrite_picture(bytes_of(before.encoded()), "skin", editor_of(kPatch));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  const RawPng after = RawPng::decoded(rewritten->bytes);
  EXPECT_EQ(after.depth, 8);
  EXPECT_EQ(after.kind, PNG_COLOR_TYPE_GRAY);
}

TEST(PngRewriter, AnInterlacedPictureKeepsItsPixels) {
  const Picture picture = soft_noise();
  const auto rewritten =
      rewrite_picture(bytes_of(interlaced_png_of(picture)), "skin", editor_of(kPatch));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  EXPECT_THAT(rewritten->note, HasSubstr("interlaced"));
  const Picture after = read_picture(rewritten->bytes, "after").value();
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x) {
      const int change = kPatch.has(x, y) ? 40 : 0;
      ASSERT_EQ(after.at(x, y)[0], picture.at(x, y)[0] + change) << x << " " << y;
    }
}

TEST(PngRewriter, ChunksStayInTheirPlacesByteForByte) {
  const RawPng picture = RawPng::noise(40, 30, 8, PNG_COLOR_TYPE_RGB);
  const std::vector<RawChunk> chunks = {
      {"gAMA", std::string("\x00\x00\xb1\x8f", 4), false},
      {"pHYs", std::string("\x00\x00\x0b\x13\x00\x00\x0b\x13\x01", 9), false},
      {"tEXt", std::string("Title\0skin", 10), false},
      {"prVt", "of a program", true},
      {"tEXt", std::string("Comment\0behind", 14), true}};
  const auto rewritten =
      rewrite_picture(bytes_of(picture.encoded(chunks)), "skin", editor_of({3, 4, 5, 6, 30}));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  EXPECT_EQ(chunks_in(rewritten->bytes), chunks);
}

TEST(PngRewriter, AnotherGammaIsRefusedByName) {
  const RawPng picture = RawPng::noise(40, 30, 8, PNG_COLOR_TYPE_RGB);
  const auto rewritten = rewrite_picture(
      bytes_of(picture.encoded({{"gAMA", std::string("\x00\x01\x86\xa0", 4), false}})), "skin",
      editor_of(kPatch));
  EXPECT_EQ(rewritten.status().code(), StatusCode::kUnimplemented);
  EXPECT_THAT(rewritten.status().message(), HasSubstr("gamma 1.0"));
}

TEST(PngRewriter, AColourThatIsCutOutStaysAndNoOtherBecomesIt) {
  RawPng picture = RawPng::noise(2, 1, 8, PNG_COLOR_TYPE_GRAY);
  picture.pixels = {50, 90};
  const RawChunk cut_out = {"tRNS", std::string("\x00\x5a", 2), false};  // 90
  const auto rewritten =
      rewrite_picture(bytes_of(picture.encoded({cut_out})), "skin", editor_of({0, 0, 2, 1, 40}));
  ASSERT_TRUE(rewritten.is_ok()) << rewritten.status().message();
  const RawPng after = RawPng::decoded(rewritten->bytes);
  EXPECT_EQ(after.value(0, 0, 0), 89);
  EXPECT_EQ(after.value(1, 0, 0), 90);
  EXPECT_EQ(chunks_in(rewritten->bytes), std::vector<RawChunk>{cut_out});
}

}  // namespace
}  // namespace burnish
