#include "common/pages/page_codec.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/common/pages/made_pages.h"

namespace burnish {
namespace {

Page round_trip(const Page& page) {
  return decode_page(encode_page(page)).value();
}

/// Returns the largest angle in degrees between normals of vertices at the same place. Places are
/// distinct.
double largest_turn(const Page& page, const Page& decoded) {
  double largest = 0;
  for (size_t v = 0; v < decoded.normals.size(); ++v) {
    const auto same = std::ranges::find(page.positions, decoded.positions[v]);
    const Vec3f& normal = page.normals[same - page.positions.begin()];
    const double cosine = std::min(1.0f, normal.dot(decoded.normals[v]));
    largest = std::max(largest, std::acos(cosine) * 180 / M_PI);
  }
  return largest;
}

TEST(PageCodec, TwoTrianglesComeBack) {
  const Page page = two_triangles();
  const Page decoded = round_trip(page);
  EXPECT_EQ(meaning_of(decoded), meaning_of(page));
  EXPECT_EQ(decoded.id, page.id);
  EXPECT_EQ(decoded.patches, page.patches);
  EXPECT_EQ(decoded.normals.size(), 2u);
  EXPECT_TRUE(decoded.colours.empty());
}

TEST(PageCodec, NormalsAlongTheAxesAreExact) {
  const Page decoded = round_trip(two_triangles());
  const bool is_first = decoded.positions[0].x() == 0;
  EXPECT_EQ(decoded.normals[is_first ? 0 : 1], Vec3f(0, 0, 1));
  EXPECT_EQ(decoded.normals[is_first ? 1 : 0], Vec3f(0, -1, 0));
}

TEST(PageCodec, EveryFieldOfRandomSheetsComesBack) {
  for (uint32_t seed = 0; seed < 64; ++seed) {
    const PageWishes wishes{.columns = 2 + static_cast<int>(seed % 9),
                            .rows = 2 + static_cast<int>(seed % 7),
                            .is_closed = seed % 4 == 1 && seed % 9 > 0 && seed % 7 > 0,
                            .patches = seed % 5 == 0 ? 0 : static_cast<int>(seed % 2 + 1),
                            .has_all_normals = seed % 3 != 0,
                            .has_colours = seed % 2 == 0};
    const Page page = made_sheet(wishes, seed);
    const Page decoded = round_trip(page);
    EXPECT_EQ(meaning_of(decoded), meaning_of(page)) << seed;
    EXPECT_EQ(decoded.patches, page.patches) << seed;
    EXPECT_EQ(decoded.border_vertices, page.border_vertices) << seed;
    EXPECT_EQ(decoded.normals.size(), page.normals.size()) << seed;
    EXPECT_LT(largest_turn(page, decoded), 1.0) << seed;
  }
}

TEST(PageCodec, SoupComesBack) {
  for (uint32_t seed = 0; seed < 64; ++seed) {
    const Page page = made_soup(3 + seed, 4 + 3 * seed, seed);
    EXPECT_EQ(meaning_of(round_trip(page)), meaning_of(page)) << seed;
  }
}

TEST(PageCodec, ADecodedPageDecodesToItsMeaningAgain) {
  const Page once = round_trip(made_sheet({}, 3));
  EXPECT_EQ(meaning_of(round_trip(once)), meaning_of(once));
}

TEST(PageCodec, TheSamePageGivesTheSameBytes) {
  EXPECT_EQ(encode_page(made_sheet({}, 5)), encode_page(made_sheet({}, 5)));
}

TEST(PageCodec, ABorderVertexHasTheSameNormalBitsInEveryPage) {
  const Page whole = made_sheet({.patches = 0, .has_all_normals = false}, 9);
  Page part = whole;  // other triangles, so that other predictions lead to the normals
  std::ranges::reverse(part.triangles[0]);
  part.triangles[5] = {0, 20, 40};
  const Page a = round_trip(whole);
  const Page b = round_trip(part);
  ASSERT_EQ(a.normals.size(), b.normals.size());
  for (size_t v = 0; v < a.normals.size(); ++v) {
    const auto same = std::ranges::find(b.positions, a.positions[v]) - b.positions.begin();
    EXPECT_EQ(a.normals[v], b.normals[same]) << v;
  }
}

TEST(PageCodec, TheLargestPagesFit) {
  const Page torus = made_sheet({.columns = 64, .rows = 32, .is_closed = true}, 1);
  ASSERT_EQ(torus.positions.size(), kPageVerticesMax);
  ASSERT_EQ(torus.triangles.size(), kPageTrianglesMax);
  const Page soup = made_soup(kPageVerticesMax, kPageTrianglesMax, 1);
  for (const Page& page : {torus, soup}) {
    const std::vector<uint8_t> bytes = encode_page(page);
    EXPECT_LT(bytes.size(), kPageBytesMax);
    EXPECT_EQ(meaning_of(decode_page(bytes).value()), meaning_of(page));
  }
}

TEST(PageCodec, ARoughSheetTakesLessThanThreeBytesATriangle) {
  const Page page = made_sheet(
      {.columns = 50, .rows = 38, .patches = 8, .has_all_normals = false, .has_colours = false}, 2);
  EXPECT_LT(encode_page(page).size(), 3 * page.triangles.size());
}

}  // namespace
}  // namespace burnish
