#include "common/sheets/sheet_codec.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/packing/checksum.h"
#include "common/packing/zstd_frame.h"
#include "common/sheets/cut_charts.h"
#include "common/sheets/webp_texels.h"
#include "tests/common/sheets/made_surfaces.h"
#include "tests/common/sheets/made_texture.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A sheet of two charts.
Sheet small_sheet() {
  Sheet sheet{.page = 7,
              .halving = 1,
              .density = 0.25f,
              .layout = {.width = 24, .height = 17, .places = {{0, 0}, {12, 3}}}};
  for (uint32_t i = 0; i < 24 * 17; ++i)
    sheet.texels.push_back(
        {static_cast<uint8_t>(9 * (i % 24)), static_cast<uint8_t>(i / 3), 100, 255});
  return sheet;
}

void seal_sheet(std::vector<uint8_t>& bytes) {
  constexpr size_t kAt = offsetof(SheetHeader, checksum);
  const uint64_t checksum = sealed_checksum(bytes, kAt, sizeof(SheetHeader));
  std::memcpy(bytes.data() + kAt, &checksum, sizeof(checksum));
}

/// Returns the message for a sheet whose header `spoil` has changed and sealed.
template <typename Spoil>
std::string spoilt_sheet(Spoil spoil) {
  std::vector<uint8_t> bytes = encode_sheet(small_sheet()).value();
  SheetHeader header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  spoil(header);
  std::memcpy(bytes.data(), &header, sizeof(header));
  seal_sheet(bytes);
  return decode_sheet(bytes).status().message();
}

/// Returns the message for a sheet with another WebP behind its places.
std::string with_webp(const std::vector<uint8_t>& webp) {
  std::vector<uint8_t> bytes = encode_sheet(small_sheet()).value();
  const size_t table = compressed_bytes(std::span(bytes).subspan(sizeof(SheetHeader))).value();
  bytes.resize(sizeof(SheetHeader) + table);
  bytes.insert(bytes.end(), webp.begin(), webp.end());
  seal_sheet(bytes);
  return decode_sheet(bytes).status().message();
}

std::vector<uint8_t> webp_of(uint32_t width, uint32_t height,
                             SheetCodec codec = SheetCodec::kLossyWebp, uint8_t alpha = 255) {
  const std::vector<Rgba8> texels(size_t{width} * height, Rgba8{1, 2, 3, alpha});
  return encode_webp(texels, width, height, codec).value();
}

double psnr_of(const std::vector<Rgba8>& texels, const std::vector<Rgba8>& others) {
  double squares = 0;
  for (size_t i = 0; i < texels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      squares += std::pow(texels[i][channel] - others[i][channel], 2) / 3;
  return 10 * std::log10(255.0 * 255.0 * static_cast<double>(texels.size()) / squares);
}

TEST(SheetCodec, ALossySheetComesBackNearly) {
  const Page page = sphere_page(30, 12000);
  const PageCharts charts = cut_charts(page, 0.01);
  const Sheet sheet = baked_sheet(page, charts, 0.01f, pattern_on(page, 2400), 1);
  const std::vector<uint8_t> bytes = encode_sheet(sheet).value();
  const Sheet read = decode_sheet(bytes).value();
  EXPECT_EQ(read.layout, sheet.layout);
  EXPECT_EQ(read.density, sheet.density);
  EXPECT_GT(psnr_of(read.texels, sheet.texels), 35);  // the pattern's colours vary more than stone
  EXPECT_LT(static_cast<double>(bytes.size()), 0.2 * static_cast<double>(sheet.texels.size()));
  EXPECT_TRUE(check_sheet_layout(read.layout, page, charts, 0.01).is_ok());
  EXPECT_EQ(encode_sheet(sheet).value(), bytes);
}

TEST(SheetCodec, ALosslessSheetComesBackExactly) {
  Sheet sheet = small_sheet();
  for (const uint8_t alpha : {uint8_t{255}, uint8_t{0}}) {
    sheet.texels[5] = {77, 88, 99, alpha};
    const Sheet read = decode_sheet(encode_sheet(sheet, SheetCodec::kLosslessWebp).value()).value();
    EXPECT_EQ(read.texels, sheet.texels);
    EXPECT_EQ(read.page, sheet.page);
    EXPECT_EQ(read.halving, sheet.halving);
  }
}

TEST(SheetCodec, AlphaIsKeptWhereThereIsAny) {
  Sheet sheet = small_sheet();
  EXPECT_EQ(decode_sheet(encode_sheet(sheet).value()).value().texels[0][3], 255);
  sheet.texels[0][3] = 30;
  const Sheet read = decode_sheet(encode_sheet(sheet).value()).value();
  EXPECT_EQ(read.texels[0][3], 30);
  EXPECT_EQ(read.texels[1][3], 255);
}

TEST(SheetCodec, EveryChangedBitIsNoticed) {
  const std::vector<uint8_t> good = encode_sheet(small_sheet()).value();
  for (size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::vector<uint8_t> bad = good;
    bad[bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
    EXPECT_FALSE(decode_sheet(bad).is_ok()) << bit;
  }
}

TEST(SheetCodec, EveryShorterAndLongerSheetIsRefused) {
  std::vector<uint8_t> bytes = encode_sheet(small_sheet()).value();
  for (size_t size = 0; size < bytes.size(); ++size) {
    std::vector<uint8_t> part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    if (size > sizeof(SheetHeader)) seal_sheet(part);
    EXPECT_EQ(decode_sheet(part).status().code(), StatusCode::kDataLoss) << size;
  }
  bytes.push_back(0);
  seal_sheet(bytes);
  EXPECT_EQ(decode_sheet(bytes).status().code(), StatusCode::kDataLoss);
}

TEST(SheetCodec, HeadersThatCannotBeAreNamed) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(spoilt_sheet([](SheetHeader&) {}), "");
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.version = 2; }), HasSubstr("version 2"));
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.codec = SheetCodec{3}; }), HasSubstr("3 codec"));
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.charts = 4097; }), HasSubstr("1..4096"));
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.charts = 1; }), HasSubstr("zstd frame of 4"));
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.halving = 8; }), HasSubstr("0..7"));
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.zero[2] = 1; }), HasSubstr("reserved"));
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.width = 1025; }),
              HasSubstr("1025 texels of width are outside 9..1024"));
  EXPECT_THAT(spoilt_sheet([](SheetHeader& h) { h.height = 8; }), HasSubstr("8 texels of height"));
  for (const float density : {0.0f, -1.0f, 0x1p40f, kNan})
    EXPECT_THAT(spoilt_sheet([&](SheetHeader& h) { h.density = density; }), HasSubstr("density"));
}

TEST(SheetCodec, ChartsOutsideTheSheetAreNamed) {
  Sheet sheet = small_sheet();
  sheet.layout.places[1] = {16, 3};
  EXPECT_THAT(decode_sheet(encode_sheet(sheet).value()).status().message(),
              HasSubstr("chart 1 lies at 16, 3, the limit is 15, 8"));
}

TEST(SheetCodec, AWebpOfAnotherSizeOrKindIsRefusedUndecoded) {
  EXPECT_EQ(with_webp(webp_of(24, 17)), "");
  EXPECT_THAT(with_webp(webp_of(25, 17)), HasSubstr("25x17 texels, the sheet 24x17"));
  EXPECT_THAT(with_webp(webp_of(24, 17, SheetCodec::kLosslessWebp)), HasSubstr("codec 2"));
  EXPECT_THAT(with_webp({}), HasSubstr("0 bytes"));
  EXPECT_THAT(with_webp(std::vector<uint8_t>(40, 1)), HasSubstr("RIFF"));
  std::vector<uint8_t> animated = webp_of(24, 17, SheetCodec::kLossyWebp, 9);
  animated.at(20) |= 2;
  EXPECT_THAT(with_webp(animated), HasSubstr("animated"));
  std::vector<uint8_t> widened = webp_of(25, 17, SheetCodec::kLossyWebp, 9);
  widened.at(24) = 23;  // the canvas of VP8X, without the frame's size
  EXPECT_THAT(with_webp(widened), HasSubstr("does not decode"));
}

TEST(OpaqueWebp, HasTheSameTexelsWithoutTheirAlpha) {
  const std::vector<uint8_t> bytes = webp_of(24, 17, SheetCodec::kLossyWebp, 9);
  const std::vector<uint8_t> alone = opaque_webp(bytes, 24, 17, SheetCodec::kLossyWebp).value();
  EXPECT_LT(alone.size(), bytes.size());
  auto texels = decode_webp(bytes, 24, 17, SheetCodec::kLossyWebp).value();
  for (Rgba8& texel : texels) texel[3] = 255;
  EXPECT_EQ(decode_webp(alone, 24, 17, SheetCodec::kLossyWebp).value(), texels);
  const std::vector<uint8_t> plain = webp_of(24, 17);
  EXPECT_EQ(opaque_webp(plain, 24, 17, SheetCodec::kLossyWebp).value(), plain);
}

TEST(OpaqueWebp, AFrameOfAnotherSizeThanItsContainerIsRefused) {
  std::vector<uint8_t> bytes = webp_of(25, 17, SheetCodec::kLossyWebp, 9);
  bytes.at(24) = 23;
  EXPECT_THAT(opaque_webp(bytes, 24, 17, SheetCodec::kLossyWebp).status().message(),
              HasSubstr("25x17 texels, the sheet 24x17"));
  bytes.at(34) = 0xff;  // the first chunk's size
  EXPECT_THAT(opaque_webp(bytes, 24, 17, SheetCodec::kLossyWebp).status().message(),
              HasSubstr("12 bytes"));
}

TEST(SheetLayoutCheck, RectanglesThatReachOutAreNamed) {
  const Page page = wavy_page(5, 100, 0);
  const PageCharts charts = cut_charts(page, 0.1);
  SheetLayout layout = lay_out_sheet(chart_sizes(page, charts, 0.1)).value();
  EXPECT_TRUE(check_sheet_layout(layout, page, charts, 0.1).is_ok());
  --layout.height;
  EXPECT_THAT(check_sheet_layout(layout, page, charts, 0.1).message(),
              HasSubstr("chart 0 ends at 49, 49"));
  layout.places.clear();
  EXPECT_THAT(check_sheet_layout(layout, page, charts, 0.1).message(),
              HasSubstr("0 charts, the page 1"));
}

}  // namespace
}  // namespace burnish
