#include "common/sheets/bake_sheet.h"

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/sheets/cut_charts.h"
#include "common/sheets/sheet_source.h"
#include "tests/common/sheets/made_surfaces.h"
#include "tests/common/sheets/made_texture.h"

namespace burnish {
namespace {

constexpr double kWave = 2400;         // steps; a pattern of 24 texels a wave
constexpr float kFineDensity = 0.01f;  // texels per step
constexpr float kCoarseDensity = 0.005f;

/// Two levels of one surface, each with its sheet. The coarser one is baked from the finer one's.
struct TwoLevels {
  Page fine;
  Page coarse;
  PageCharts fine_charts = cut_charts(fine, kFineDensity);
  PageCharts coarse_charts = cut_charts(coarse, kCoarseDensity);
  Sheet fine_sheet = baked_sheet(fine, fine_charts, kFineDensity, pattern_on(fine, kWave), 1);

  Sheet coarse_sheet() const {
    const std::vector<SheetedPage> pages = {{&fine, &fine_charts, &fine_sheet}};
    return baked_sheet(coarse, coarse_charts, kCoarseDensity, source_of_sheets(pages, 1), 2);
  }
  double fine_psnr() const { return psnr_to_pattern(fine, fine_charts, fine_sheet, kWave); }
  double coarse_psnr() const {
    return psnr_to_pattern(coarse, coarse_charts, coarse_sheet(), kWave);
  }
};

/// Returns a height field of one chart a level.
TwoLevels wavy_levels() {
  return {.fine = wavy_page(41, 500, 1500), .coarse = wavy_page(21, 1000, 1500)};
}

/// Returns a closed surface of several charts a level.
TwoLevels sphere_levels() {
  return {.fine = sphere_page(31, 12000), .coarse = sphere_page(24, 12000)};
}

TEST(BakeSheet, TheFinestSheetShowsItsSource) {
  EXPECT_GT(wavy_levels().fine_psnr(), 45);
  EXPECT_GT(sphere_levels().fine_psnr(), 45);
}

TEST(BakeSheet, ACoarserSheetShowsTheFinerOne) {
  EXPECT_GT(wavy_levels().coarse_psnr(), 38);
  EXPECT_GT(sphere_levels().coarse_psnr(), 38);
}

TEST(BakeSheet, ATriangleThinnerThanATexelShowsItsSource) {
  Page page;
  page.positions = {{1000, 1000, 1000}, {9000, 1010, 1200}, {5000, 1015, 1100}};
  page.triangles = {{0, 1, 2}};
  page.patches = {{kNoPage, 1}};
  const PageCharts charts = cut_charts(page, kFineDensity);
  const BakeSource source = {
      {{Vec3d(1000, 1000, 1000), Vec3d(9000, 1010, 1200), Vec3d(5000, 1015, 1100)}},
      [](uint32_t, const Vec3d&) { return Texel::Constant(200); }};
  for (const int samples : {1, 2}) {
    const Sheet sheet = baked_sheet(page, charts, kFineDensity, source, samples);
    for (const Rgba8& texel : sheet.texels) ASSERT_EQ(texel[0], 200) << samples;
  }
}

/// Returns a roof whose sides face 60 degrees apart: a chart each. The left side comes first.
Page roof_page() {
  Page page;
  for (int y = 0; y <= 8; ++y)
    for (const auto& [x, z] :
         {std::array{1000, 1000}, std::array{2000, 1577}, std::array{3000, 1000}})
      page.positions.emplace_back(x, 1000 + 200 * y, z);
  for (const int left : {0, 1})
    for (int y = 0; y < 8; ++y) {
      const auto at = [&](int step) { return static_cast<uint16_t>(3 * y + left + step); };
      page.triangles.push_back({at(0), at(1), at(3)});
      page.triangles.push_back({at(3), at(1), at(4)});
    }
  page.patches = {{kNoPage, 32}};
  return page;
}

TEST(BakeSheet, TheGutterGoesOnWithTheNeighbouringChart) {
  const Page page = roof_page();
  const PageCharts charts = cut_charts(page, kFineDensity);
  ASSERT_EQ(charts.charts.size(), 2u);
  BakeSource source = pattern_on(page, kWave);
  source.texel = [](uint32_t triangle, const Vec3d&) -> Texel {
    return Texel::Constant(triangle < 16 ? 200.0f : 50.0f);
  };
  const Sheet sheet = baked_sheet(page, charts, kFineDensity, source, 1);
  const TexelSize size = chart_sizes(page, charts, kFineDensity)[0];
  const TexelPlace& place = sheet.layout.places[0];
  size_t beyond = 0;
  for (uint32_t y = place.y; y < place.y + size.height; ++y)
    for (uint32_t x = place.x; x < place.x + size.width; ++x)
      if (sheet.texels[size_t{y} * sheet.layout.width + x][0] == 50) ++beyond;
  EXPECT_GE(beyond, 2u * 16);  // two texels wide at least, along the ridge
}

TEST(BakeSheet, OfTwoLayersTheNearerOneIsTaken) {
  const Page page = wavy_page(5, 1000, 0);
  const PageCharts charts = cut_charts(page, kFineDensity);
  BakeSource source = pattern_on(page, kWave);
  const size_t layer = source.triangles.size();
  for (const double height : {-900.0, 900.0})
    for (size_t t = 0; t < layer; ++t) {
      auto corners = source.triangles[t];
      for (Vec3d& corner : corners) corner.z() += height;
      source.triangles.push_back(corners);
    }
  source.texel = [layer](uint32_t triangle, const Vec3d&) -> Texel {
    return Texel::Constant(triangle < layer ? 200.0f : 10.0f);
  };
  for (const Rgba8& texel : baked_sheet(page, charts, kFineDensity, source, 2).texels)
    EXPECT_EQ(texel, (Rgba8{200, 200, 200, 200}));
}

TEST(BakeSheet, TrianglesThatFaceAwayAreNotTaken) {
  const Page page = wavy_page(5, 1000, 0);
  BakeSource source = pattern_on(page, kWave);
  for (auto& corners : source.triangles) std::swap(corners[0], corners[1]);
  const PageCharts charts = cut_charts(page, kFineDensity);
  for (const Rgba8& texel : baked_sheet(page, charts, kFineDensity, source, 1).texels)
    EXPECT_EQ(texel, (Rgba8{0, 0, 0, 255}));
}

TEST(BakeSheet, AnyNumberOfThreadsMakesTheSameTexels) {
  const TwoLevels levels = wavy_levels();
  const int before = thread_count();
  std::vector<std::vector<Rgba8>> made;
  for (const int threads : {1, 3}) {
    use_threads(threads);
    std::vector<std::vector<Rgba8>> baked(4);
#pragma omp parallel for schedule(dynamic)
    for (int run = 0; run < 4; ++run) baked[run] = levels.coarse_sheet().texels;
    made.insert(made.end(), baked.begin(), baked.end());
  }
  use_threads(before);
  for (const auto& texels : made) EXPECT_EQ(texels, made[0]);
}

TEST(PushPull, KnownTexelsStayAndOthersLieBetween) {
  TexelGrid grid(13, 7);
  grid.texels[grid.at(1, 1)] = Texel::Constant(40);
  grid.texels[grid.at(11, 5)] = Texel::Constant(80);
  grid.is_known[grid.at(1, 1)] = grid.is_known[grid.at(11, 5)] = 1;
  push_pull(grid);
  EXPECT_EQ(grid.texels[grid.at(1, 1)][0], 40);
  EXPECT_EQ(grid.texels[grid.at(11, 5)][0], 80);
  for (const Texel& texel : grid.texels) {
    EXPECT_GE(texel[0], 40);
    EXPECT_LE(texel[0], 80);
  }
  EXPECT_LT(grid.texels[grid.at(0, 0)][0], grid.texels[grid.at(12, 6)][0]);
}

TEST(PushPull, AGridWithoutAKnownTexelIsLeft) {
  TexelGrid grid(3, 3);
  push_pull(grid);
  EXPECT_EQ(grid.is_known, std::vector<uint8_t>(9, 0));
}

}  // namespace
}  // namespace burnish
