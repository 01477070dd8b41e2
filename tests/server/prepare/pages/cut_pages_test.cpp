#include "server/prepare/pages/cut_pages.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "common/base/parallel.h"
#include "server/prepare/pages/page_vertices.h"
#include "tests/server/prepare/pages/pages_test_meshes.h"

namespace burnish {
namespace {

class CutPages : public testing::Test {
 protected:
  PageGroups cut(const TriangleMesh& mesh, int level = 0, const PageTexels& texels = {}) {
    const MeshStatistics statistics = compute_statistics(mesh);
    const PageVertices placed = place_vertices({mesh.vertices, mesh.triangles, {}, statistics}, {});
    return cut_pages({mesh.triangles, placed.positions, placed.grid.bits, level,
                      1.05 * mesh.vertices.size() / mesh.triangles.size(), texels},
                     {});
  }
};

TEST_F(CutPages, EveryTriangleIsInOnePageThatIsNotTooLarge) {
  const TriangleMesh meshes[] = {scan_of_kind("tablet", 60'000), scan_of_kind("soup", 60'000),
                                 tangle(5000, 50'000)};
  for (const TriangleMesh& mesh : meshes) {
    const PageGroups pages = cut(mesh);
    std::vector<uint32_t> all(pages.item.begin(), pages.item.end());
    std::ranges::sort(all);
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) ASSERT_EQ(all[t], t);
    for (size_t page = 0; page < pages.count(); ++page) {
      std::set<uint32_t> vertices;
      for (const uint32_t t : pages[page])
        vertices.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
      EXPECT_LE(vertices.size(), kPageVerticesMax);
      EXPECT_LE(pages[page].size(), kPageTrianglesMax);
      EXPECT_TRUE(std::ranges::is_sorted(pages[page]));
    }
  }
}

TEST_F(CutPages, PagesOfACleanScanAreNearlyFull) {
  const TriangleMesh mesh = scan_of_kind("blob", 100'000);
  EXPECT_GT(static_cast<double>(mesh.triangles.size()) / cut(mesh).count(), 3400);
}

TEST_F(CutPages, PagesOfSeveralTrianglesHaveTheirTexelsAtMost) {
  const TriangleMesh mesh = scan_of_kind("blob", 10'000);
  std::vector<float> texels(mesh.triangles.size(), 10);
  for (size_t t = 0; t < 100; ++t) texels[t] = 900;
  texels[7] = 50'000;
  const PageGroups pages = cut(mesh, 0, {texels, 2000});
  size_t alone = 0;
  for (size_t page = 0; page < pages.count(); ++page) {
    double sum = 0;
    for (const uint32_t t : pages[page]) sum += texels[t];
    if (pages[page].size() > 1)
      EXPECT_LE(sum, 2000);
    else
      alone += pages[page][0] == 7;
  }
  EXPECT_EQ(alone, 1u);
  EXPECT_LT(pages.count(), 3 * (10.0 * texels.size() + 100 * 900) / 2000);
}

/// Returns the triangles of a square of quads of side 1.
TriangleMesh square(uint32_t quads) {
  TriangleMesh mesh;
  for (uint32_t y = 0; y <= quads; ++y)
    for (uint32_t x = 0; x <= quads; ++x) mesh.vertices.push_back({double(x), double(y), 0});
  for (uint32_t y = 0; y < quads; ++y)
    for (uint32_t x = 0; x < quads; ++x) {
      const uint32_t a = y * (quads + 1) + x;
      mesh.triangles.push_back({a, a + 1, a + quads + 2});
      mesh.triangles.push_back({a, a + quads + 2, a + quads + 1});
    }
  return mesh;
}

TEST_F(CutPages, APageWithADensePartIsNoLargerThanASheetForIt) {
  constexpr uint32_t kQuads = 40, kDense = 8;
  const TriangleMesh mesh = square(kQuads);
  std::vector<float> texels;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const uint32_t quad = t / 2;
    texels.push_back(quad % kQuads < kDense && quad / kQuads < kDense ? 100 : 1);
  }
  const PageGroups pages = cut(mesh, 0, {texels, 16'000});
  size_t sharp = 0;  // dense triangles
  for (size_t page = 0; page < pages.count(); ++page)
    if (100 * pages[page].size() <= 2 * 16'000)
      sharp += std::ranges::count_if(pages[page], [&](uint32_t t) { return texels[t] > 1; });
  EXPECT_GE(sharp, 0.95 * 2 * kDense * kDense);
  EXPECT_LE(pages.count(), 24u);
}

TEST_F(CutPages, DensityThatChangesEverywhereMakesFewPages) {
  const TriangleMesh mesh = square(400);
  std::vector<float> texels(mesh.triangles.size(), 1);
  for (size_t t = 0; t < texels.size(); t += 25) texels[t] = 10'000;
  EXPECT_LE(cut(mesh, 0, {texels, 1e6}).count(), 1024u);
}

TEST(NeededTexelDensity, IsTheMeanWherePartsAreAboutAsDense) {
  EXPECT_DOUBLE_EQ(needed_texel_density({{400, 100}, {500, 100}}), std::sqrt(4.5));
}

TEST(NeededTexelDensity, IsThatOfAMuchDenserPart) {
  EXPECT_DOUBLE_EQ(needed_texel_density({{400, 1}, {100, 100}, {100, 100}}), 20);
}

TEST(NeededTexelDensity, FewTexelsMayBeDenser) {
  EXPECT_NEAR(needed_texel_density({{4, 0.0001}, {100, 100}, {100, 100}}), 1, 0.02);
}

TEST_F(CutPages, NeedlesOfAStripStayBesideTheirNeighbours) {
  constexpr uint32_t kStrips = 1000;
  TriangleMesh mesh;
  for (uint32_t x = 0; x <= kStrips; ++x)
    for (const double y : {0.0, 1.0}) mesh.vertices.push_back({x / double{kStrips}, y, 0});
  for (uint32_t v = 0; v < 2 * kStrips; v += 2) {
    mesh.triangles.push_back({v, v + 2, v + 3});
    mesh.triangles.push_back({v, v + 3, v + 1});
  }
  const std::vector<float> texels(mesh.triangles.size(), 10);
  const PageGroups pages = cut(mesh, 0, {texels, 1000});
  EXPECT_GT(pages.count(), 20u);
  size_t strips = 0;  // whole in one page
  for (size_t page = 0; page < pages.count(); ++page)
    for (size_t i = 1; i < pages[page].size(); ++i)
      strips += pages[page][i] == pages[page][i - 1] + 1 && pages[page][i] % 2 == 1;
  EXPECT_GT(strips, 0.9 * kStrips);
}

TEST_F(CutPages, SeveralRunsOfTheCurveHoldEveryTriangleOnce) {
  const TriangleMesh mesh = scan_of_kind("icosphere", 400'000);
  const PageGroups pages = cut(mesh, 3);
  std::vector<uint32_t> all(pages.item.begin(), pages.item.end());
  std::ranges::sort(all);
  ASSERT_EQ(all.size(), mesh.triangles.size());
  for (uint32_t t = 0; t < all.size(); ++t) ASSERT_EQ(all[t], t);
}

TEST_F(CutPages, ThreadsDoNotMatter) {
  const TriangleMesh mesh = scan_of_kind("blob", 100'000);
  use_threads(1);
  const PageGroups alone = cut(mesh);
  use_threads(4);
  const PageGroups together = cut(mesh);
  EXPECT_TRUE(std::ranges::equal(alone.item, together.item));
  EXPECT_EQ(alone.start, together.start);
}

TEST_F(CutPages, BordersMoveFromLevelToLevel) {
  const TriangleMesh mesh = scan_of_kind("blob", 100'000);
  const auto page_of = [&](const PageGroups& pages) {
    std::vector<size_t> of_triangle(mesh.triangles.size());
    for (size_t page = 0; page < pages.count(); ++page)
      for (const uint32_t t : pages[page]) of_triangle[t] = page;
    return of_triangle;
  };
  const std::vector<size_t> first = page_of(cut(mesh, 0)), second = page_of(cut(mesh, 1));
  std::set<std::pair<size_t, size_t>> overlaps;
  for (size_t t = 0; t < first.size(); ++t) overlaps.emplace(first[t], second[t]);
  EXPECT_GT(overlaps.size(), 2 * cut(mesh, 0).count());
}

}  // namespace
}  // namespace burnish
