#include "common/sheets/sheet_layout.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "common/sheets/cut_charts.h"
#include "common/sheets/sheet_density.h"
#include "common/sheets/sheet_limits.h"
#include "tests/common/sheets/made_surfaces.h"

namespace burnish {
namespace {

std::vector<TexelSize> random_sizes(size_t count, uint32_t most, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<TexelSize> sizes;
  for (size_t i = 0; i < count; ++i)
    sizes.push_back(
        {static_cast<uint32_t>(9 + random() % most), static_cast<uint32_t>(9 + random() % most)});
  return sizes;
}

/// Returns the part of the sheet that the rectangles cover, or 0 if two overlap or one is outside.
double filled_part(const SheetLayout& layout, const std::vector<TexelSize>& sizes) {
  std::vector<uint8_t> is_taken(layout.texels(), 0);
  size_t taken = 0;
  for (size_t c = 0; c < sizes.size(); ++c) {
    const TexelPlace& place = layout.places[c];
    if (place.x + sizes[c].width > layout.width || place.y + sizes[c].height > layout.height)
      return 0;
    for (uint32_t y = place.y; y < place.y + sizes[c].height; ++y)
      for (uint32_t x = place.x; x < place.x + sizes[c].width; ++x, ++taken)
        if (is_taken[size_t{y} * layout.width + x]++ != 0) return 0;
  }
  return static_cast<double>(taken) / static_cast<double>(layout.texels());
}

TEST(SheetLayout, RectanglesLieInsideWithoutOverlap) {
  for (const uint32_t seed : {1u, 2u, 3u})
    for (const size_t count : {1u, 2u, 40u, 300u}) {
      const auto sizes = random_sizes(count, 60, seed);
      const auto layout = lay_out_sheet(sizes);
      ASSERT_TRUE(layout.has_value());
      EXPECT_GT(filled_part(*layout, sizes), count < 3 ? 0.3 : 0.8) << count;
    }
}

TEST(SheetLayout, OneChartTakesASheetOfItsSize) {
  const auto layout = lay_out_sheet(std::vector<TexelSize>{{1009, 9}}).value();
  EXPECT_EQ(layout.width, 1009);
  EXPECT_EQ(layout.height, 9);
}

TEST(SheetLayout, WhatDoesNotFitIsRefused) {
  EXPECT_FALSE(lay_out_sheet(std::vector<TexelSize>{{1025, 9}}).has_value());
  EXPECT_FALSE(lay_out_sheet(std::vector<TexelSize>{{9, 1025}}).has_value());
  EXPECT_FALSE(lay_out_sheet(std::vector<TexelSize>(3, {600, 600})).has_value());
  EXPECT_TRUE(lay_out_sheet(std::vector<TexelSize>(4, {512, 512})).has_value());
}

TEST(SheetLayout, ThousandsOfSmallChartsFit) {
  const std::vector<TexelSize> charts(4096, {9, 9});
  EXPECT_GT(filled_part(lay_out_sheet(charts).value(), charts), 0.95);
}

TEST(SheetLayout, TheGutterLiesAroundEachChart) {
  const Page page = sphere_page(20, 1e5);
  const PageCharts charts = cut_charts(page, 2e-3);
  const std::vector<TexelSize> sizes = chart_sizes(page, charts, 2e-3);
  const SheetLayout layout = lay_out_sheet(sizes).value();
  for (size_t t = 0; t < page.triangles.size(); ++t) {
    const size_t c = charts.of_triangle[t];
    const ChartMapping map = chart_mapping(charts.charts[c], 2e-3, layout.places[c]);
    for (const uint16_t vertex : page.triangles[t]) {
      const Vec3d p = page.positions[vertex].cast<double>();
      const double x = map.u.dot(p) + map.x - layout.places[c].x;
      const double y = map.v.dot(p) + map.y - layout.places[c].y;
      EXPECT_GE(std::min(x, y), kSheetGutter + 0.5 - 1e-9);
      EXPECT_LE(x, sizes[c].width - kSheetGutter - 0.5 + 1e-9);
      EXPECT_LE(y, sizes[c].height - kSheetGutter - 0.5 + 1e-9);
    }
  }
}

TEST(SheetDensity, AnEdgeOfAnEquilateralTriangleHasTheWantedTexels) {
  const double area = std::sqrt(3.0) / 4 * 25;  // an edge of 5
  EXPECT_NEAR(5 * edge_density(8, 1, area), 8, 1e-12);
  EXPECT_NEAR(5 * edge_density(8, 10, 10 * area), 8, 1e-12);
}

TEST(SheetDensity, ACoarsePageHasNoMoreThanTheDensestOfItsFinerPages) {
  const double area = std::sqrt(3.0) / 4;
  EXPECT_NEAR(coarse_density(std::vector<double>{20, 3}, 1, area), 8, 1e-12);
  EXPECT_NEAR(coarse_density(std::vector<double>{3, 6}, 1, area), 6, 1e-12);
}

TEST(SheetDensity, HalvesEndAtTwoTexelsAnEdge) {
  const double area = std::sqrt(3.0) / 4;  // an edge of 1: densities are texels an edge
  EXPECT_EQ(sheet_count(8.01, 1, area), 3u);
  EXPECT_EQ(sheet_count(7.99, 1, area), 2u);
  EXPECT_EQ(sheet_count(1, 1, area), 1u);
  EXPECT_EQ(sheet_count(1e9, 1, area), kSheetsPerPageMax);
}

TEST(SheetDensity, ChartsThatDoNotFitAreCoarser) {
  const Page page = wavy_page(20, 100, 0);
  const PageCharts charts = cut_charts(page, 1);
  const FittedSheet fitted = fit_sheet(page, charts, 1);
  EXPECT_LT(fitted.texels_per_step, 0.6);
  EXPECT_GT(fitted.texels_per_step, 0.4);
  EXPECT_LE(fitted.layout.width, kSheetSideMax);
  EXPECT_DOUBLE_EQ(fit_sheet(page, charts, 0.1).texels_per_step, 0.1);
}

}  // namespace
}  // namespace burnish
