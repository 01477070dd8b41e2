#include "common/picture/texture_samples.h"

#include <gtest/gtest.h>

#include "tests/common/picture/encoding.h"

namespace burnish {
namespace {

Picture speckled() {
  return drawn(13, 9, [](uint32_t x, uint32_t y) {
    return Rgba8{static_cast<uint8_t>(37 * x + 11 * y), static_cast<uint8_t>(x * y), 9, 255};
  });
}

/// Coordinates inside, at borders and beyond.
std::vector<std::pair<double, double>> coordinates() {
  std::vector<std::pair<double, double>> all;
  for (double u = -1.3; u < 2.4; u += 0.17)
    for (double v = -0.6; v < 1.7; v += 0.13) all.emplace_back(u, v);
  return all;
}

/// Returns the colours by rows, of an interlaced file or another.
std::vector<Rgba8> colours_by_rows(const std::string& file, const TextureWraps& wraps) {
  const auto all = coordinates();
  TextureSamples samples(all.size());
  PictureSize size;
  const auto begin = [&](const PictureSize& announced) {
    size = announced;
    for (const auto& [u, v] : all) samples.add(pixels_around(u, v, size.width, size.height, wraps));
    samples.sort();
    return Status::ok();
  };
  const auto take = [&](const PixelRun& run) { samples.take(run); };
  const std::span bytes{reinterpret_cast<const uint8_t*>(file.data()), file.size()};
  EXPECT_TRUE(read_picture_rows(bytes, "skin", {begin, take}).is_ok());
  std::vector<Rgba8> colours;
  for (size_t i = 0; i < all.size(); ++i)
    colours.push_back(
        mixed_colour(samples.pixels(i),
                     pixels_around(all[i].first, all[i].second, size.width, size.height, wraps)));
  return colours;
}

TEST(TextureSamples, RowsInAnyOrderGiveTheColoursOfTheWholePicture) {
  const Picture picture = speckled();
  for (const TextureWrap wrap : {TextureWrap::kRepeat, TextureWrap::kMirror, TextureWrap::kClamp}) {
    std::vector<Rgba8> whole;
    for (const auto& [u, v] : coordinates())
      whole.push_back(sample_texture(picture, u, v, {wrap, wrap}));
    EXPECT_EQ(colours_by_rows(png_of(picture), {wrap, wrap}), whole);
    EXPECT_EQ(colours_by_rows(interlaced_png_of(picture), {wrap, wrap}), whole);
  }
}

}  // namespace
}  // namespace burnish
