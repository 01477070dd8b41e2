#include "common/sheets/cut_charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/sheets/sheet_limits.h"
#include "tests/common/pages/made_pages.h"
#include "tests/common/sheets/made_surfaces.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Returns the least cosine between a triangle's normal and its chart's.
double least_facing(const Page& page, const PageCharts& charts) {
  double least = 1;
  for (size_t t = 0; t < page.triangles.size(); ++t) {
    const auto p = [&](int k) -> Vec3d {
      return page.positions[page.triangles[t][k]].cast<double>();
    };
    const Vec3d area = (p(1) - p(0)).cross(p(2) - p(0));
    if (area.norm() == 0) continue;
    const Vec3d axis = axes_of(charts.charts[charts.of_triangle[t]]).normal;
    least = std::min(least, area.normalized().dot(axis));
  }
  return least;
}

TEST(Chart, AxesAreRightHandedUnitVectors) {
  for (const auto& normal :
       {std::array<int16_t, 2>{0, 0}, {32767, 0}, {-32767, -32767}, {9, -20000}})
    for (const uint16_t angle : {0, 1365, 16384, 65535}) {
      const ChartAxes axes = axes_of({.normal = normal, .angle = angle});
      EXPECT_NEAR(axes.u.norm(), 1, 1e-12);
      EXPECT_NEAR(axes.u.dot(axes.v), 0, 1e-12);
      EXPECT_NEAR((axes.u.cross(axes.v) - axes.normal).norm(), 0, 1e-12);
    }
}

TEST(CutCharts, AFlatPageIsOneChartAlongItsSides) {
  const Page page = wavy_page(20, 100, 0);
  const PageCharts charts = cut_charts(page, 0.1);
  ASSERT_EQ(charts.charts.size(), 1u);
  EXPECT_NEAR(axes_of(charts.charts[0]).normal.z(), 1, 1e-9);
  const ChartExtent extent = chart_extents(page, charts)[0];
  EXPECT_NEAR(extent.u * extent.v, 1900 * 1900, 1e4);
}

TEST(CutCharts, ASphereHasFewChartsThatFaceTheirTriangles) {
  const Page page = sphere_page(30, 1e5);
  const PageCharts charts = cut_charts(page, 1e-3);
  EXPECT_TRUE(check_charts(page, charts).is_ok());
  EXPECT_GE(charts.charts.size(), 4u);
  EXPECT_LE(charts.charts.size(), 16u);
  EXPECT_GT(least_facing(page, charts), 0.29);
  EXPECT_EQ(covered_twice(page, charts, 1e-3), 0u);
}

TEST(CutCharts, ARampAboveItselfIsCutWhereItCovers) {
  const Page page = ramp_page(1e4);
  const PageCharts charts = cut_charts(page, 0.01);
  EXPECT_GE(charts.charts.size(), 2u);
  EXPECT_LE(charts.charts.size(), 6u);
  EXPECT_EQ(covered_twice(page, charts, 0.01), 0u);
}

TEST(CutCharts, ASoupIsCutWithoutOverlap) {
  const Page page = made_soup(60, 200, 3);
  const PageCharts charts = cut_charts(page, 1e-5);
  EXPECT_TRUE(check_charts(page, charts).is_ok());
  EXPECT_EQ(covered_twice(page, charts, 1e-5), 0u);
}

TEST(CutCharts, NoSideHasMoreThanAThousandTexels) {
  const Page page = wavy_page(20, 100, 0);
  const PageCharts charts = cut_charts(page, 2);
  EXPECT_GE(charts.charts.size(), 16u);
  for (const ChartExtent& extent : chart_extents(page, charts)) {
    EXPECT_LE(extent.u * 2, kChartTexelsMax);
    EXPECT_LE(extent.v * 2, kChartTexelsMax);
  }
  EXPECT_TRUE(check_charts(page, charts).is_ok());
}

TEST(CutCharts, ALoneTriangleStaysWhole) {
  const Page page = two_triangles();
  const PageCharts charts = cut_charts(page, 1);
  EXPECT_EQ(charts.charts.size(), 2u);
}

TEST(CutCharts, DoubledVerticesDoNotCut) {
  const Page page = wavy_page(12, 100, 0);
  EXPECT_EQ(cut_charts(torn_page(page), 0.1), cut_charts(page, 0.1));
}

TEST(CutCharts, TrianglesWithoutAnAreaAreTaken) {
  Page page = wavy_page(4, 100, 0);
  page.triangles.push_back({0, 1, 1});
  page.triangles.push_back({0, 1, 2});
  page.patches[0].triangles += 2;
  ASSERT_TRUE(check_page(page).is_ok());
  EXPECT_TRUE(check_charts(page, cut_charts(page, 0.1)).is_ok());
}

TEST(CheckCharts, ChartsThatCannotBeAreNamed) {
  const Page page = two_triangles();
  const auto checked = [&](auto spoil) {
    PageCharts charts = cut_charts(page, 1);
    spoil(charts);
    return check_charts(page, charts).message();
  };
  EXPECT_EQ(checked([](PageCharts&) {}), "");
  EXPECT_THAT(checked([](PageCharts& c) { c.charts.resize(3); }),
              HasSubstr("3 charts are outside 1..2"));
  EXPECT_THAT(checked([](PageCharts& c) { c.of_triangle.pop_back(); }), HasSubstr("1 triangles"));
  EXPECT_THAT(checked([](PageCharts& c) { c.of_triangle = {1, 0}; }), HasSubstr("the limit is 0"));
  EXPECT_THAT(checked([](PageCharts& c) { c.of_triangle = {0, 2}; }), HasSubstr("in chart 2"));
  EXPECT_THAT(checked([](PageCharts& c) { c.of_triangle = {0, 0}; }), HasSubstr("chart 1 of 2"));
  EXPECT_THAT(checked([](PageCharts& c) { c.charts[0].least[1] += 1000; }),
              HasSubstr("after vertex"));
}

}  // namespace
}  // namespace burnish
