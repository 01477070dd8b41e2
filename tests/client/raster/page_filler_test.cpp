#include "client/raster/page_filler.h"

#include <algorithm>
#include <bit>

#include <gtest/gtest.h>

#include "client/raster/nearness_tiles.h"
#include "client/scene/raw_pages.h"
#include "common/generate/generate.h"

namespace burnish {
namespace {

constexpr ImageSize kSmallPicture{160, 120};

Visibility nothing_seen(int samples) {
  const size_t pixels = size_t(kSmallPicture.width) * kSmallPicture.height;
  return {kSmallPicture, samples, std::vector<SampleKey>(pixels * samples)};
}

// Each page alone hides nothing of another.
TEST(PageFiller, HiddenPagesLeaveThePictureAsItIs) {
  const RawPages raw = make_raw_pages(generate_scan({"blob", 60000}).value());
  std::vector<RasterPage> pages(raw.pages.size());
  std::vector<PatchRange> patches;
  for (uint32_t slot = 0; slot < pages.size(); ++slot) {
    pages[slot].put(raw.pages[slot]);
    patches.push_back({slot, 0, static_cast<uint32_t>(pages[slot].triangles.size())});
  }
  ASSERT_GT(pages.size(), 20u);
  WorkCrew crew(2);
  const FilledPart part{{0, kSmallPicture.width}, false};
  for (const bool is_parallel : {false, true})
    for (const double nearer : {1.0, 3.0, 20.0})
      for (const int samples : {1, 4}) {
        Camera camera{.azimuth_degrees = 31 * nearer, .orthographic = is_parallel};
        camera = frame_all(camera, raw.box, kSmallPicture.aspect());
        camera.distance /= nearer;
        const PageProjection projection = make_page_projection(raw.space, camera, kSmallPicture);
        Visibility together = nothing_seen(samples), expected = nothing_seen(samples);
        fill_pages(pages, projection, patches, part, crew, together);
        for (const PatchRange& patch : patches) {
          Visibility alone = nothing_seen(samples);
          fill_pages(pages, projection, {&patch, 1}, part, crew, alone);
          for (size_t i = 0; i < alone.keys.size(); ++i)
            expected.keys[i] = std::max(expected.keys[i], alone.keys[i]);
        }
        EXPECT_EQ(together.keys, expected.keys) << nearer << " " << samples;
      }
}

TEST(NearnessTiles, HideWhatLiesBehindEverySampleOfABox) {
  Visibility picture = nothing_seen(1);
  const auto key = [](float nearness) {
    return SampleKey{std::bit_cast<uint32_t>(nearness)} << 32 | 1;
  };
  for (int y = 10; y < 50; ++y)
    for (int x = 10; x < 50; ++x) picture.keys[picture.place(x, y)] = key(0.5f);
  WorkCrew crew(1);
  NearnessTiles tiles;
  tiles.measure(picture, crew);
  EXPECT_TRUE(tiles.hide({20, 20, 40, 40, 0.49f}));
  EXPECT_FALSE(tiles.hide({20, 20, 40, 40, 0.5f}));
  EXPECT_FALSE(tiles.hide({20, 20, 50, 40, 0.49f}));
  EXPECT_FALSE(tiles.hide({0, 0, 159, 119, 0.49f}));
  picture.keys[picture.place(30, 30)] = key(0.3f);
  tiles.measure(picture, crew);
  EXPECT_FALSE(tiles.hide({20, 20, 40, 40, 0.49f}));
  EXPECT_TRUE(tiles.hide({20, 20, 40, 40, 0.29f}));
}

}  // namespace
}  // namespace burnish
