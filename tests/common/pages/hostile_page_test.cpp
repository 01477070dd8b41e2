#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/pages/page_codec.h"
#include "common/pages/page_header.h"
#include "tests/common/pages/made_pages.h"

namespace burnish {
namespace {

using testing::HasSubstr;

StatusCode code_of(std::span<const uint8_t> bytes) {
  return decode_page(bytes).status().code();
}

/// Returns the message for two triangles whose header `spoil` has changed and sealed again.
template <typename Spoil>
std::string spoilt(Spoil spoil) {
  std::vector<uint8_t> bytes = encode_page(two_triangles());
  PageHeader header = read_page_header(bytes).value();
  spoil(header);
  seal_page(header, bytes);
  return decode_page(bytes).status().message();
}

/// Returns what check_page() says of two triangles that `spoil` has changed.
template <typename Spoil>
std::string checked(Spoil spoil) {
  Page page = two_triangles();
  spoil(page);
  return check_page(page).message();
}

TEST(HostilePage, EveryChangedBitIsNoticed) {
  const std::vector<uint8_t> good = encode_page(made_sheet({.columns = 3, .rows = 3}, 1));
  for (size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::vector<uint8_t> bad = good;
    bad[bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
    EXPECT_FALSE(decode_page(bad).is_ok()) << bit;
  }
}

TEST(HostilePage, EveryShorterAndLongerPageIsRefused) {
  std::vector<uint8_t> bytes = encode_page(two_triangles());
  for (size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(code_of(std::span(bytes).first(size)), StatusCode::kDataLoss) << size;
  bytes.push_back(0);
  EXPECT_EQ(code_of(bytes), StatusCode::kDataLoss);
}

TEST(HostilePage, AnotherVersionIsUnimplemented) {
  std::vector<uint8_t> bytes = encode_page(two_triangles());
  bytes[4] = 2;
  EXPECT_EQ(code_of(bytes), StatusCode::kUnimplemented);
}

TEST(HostilePage, CountsOutsideTheirLimitsAreNamed) {
  EXPECT_EQ(spoilt([](PageHeader&) {}), "");
  EXPECT_THAT(spoilt([](PageHeader& h) { h.vertices = 2049; }), HasSubstr("2049 vertices"));
  EXPECT_THAT(spoilt([](PageHeader& h) { h.vertices = 0; }), HasSubstr("1..2048"));
  EXPECT_THAT(spoilt([](PageHeader& h) { h.triangles = 4097; }), HasSubstr("1..4096"));
  EXPECT_THAT(spoilt([](PageHeader& h) { h.border_vertices = 5; }), HasSubstr("0..4"));
  EXPECT_THAT(spoilt([](PageHeader& h) { h.patches = 3; }), HasSubstr("3 patches"));
  EXPECT_THAT(spoilt([](PageHeader& h) { h.place_bytes = 5; }), HasSubstr("0..4"));
  EXPECT_THAT(spoilt([](PageHeader& h) { h.flags = 4; }), HasSubstr("4 flags"));
  EXPECT_THAT(spoilt([](PageHeader& h) { h.zero16 = 1; }), HasSubstr("reserved"));
}

TEST(HostilePage, CountsThatTheBodyDoesNotHaveAreRefused) {
  for (const auto spoil :
       {+[](PageHeader& h) { ++h.vertices; }, +[](PageHeader& h) { ++h.steps; },
        +[](PageHeader& h) { ++h.triangles; }, +[](PageHeader& h) { h.named_vertices = 65535; },
        +[](PageHeader& h) { ++h.border_vertices; }, +[](PageHeader& h) { h.flags = 3; }})
    EXPECT_NE(spoilt(spoil), "");
}

TEST(HostilePage, ACoordinateOutsideEveryLatticeIsNamed) {
  EXPECT_THAT(spoilt([](PageHeader& h) { h.first_position[1] = 1u << 24; }),
              HasSubstr("25 bits, the limit is 24"));
}

TEST(PageChecks, LimitsAreNamed) {
  EXPECT_EQ(checked([](Page&) {}), "");
  EXPECT_THAT(checked([](Page& p) { p.positions.resize(2049, Vec3i::Zero()); }),
              HasSubstr("2049 vertices, it must be 1..2048"));
  EXPECT_THAT(checked([](Page& p) {
                p.triangles.resize(4097, {0, 1, 2});
              }),
              HasSubstr("4097 triangles, it must be 1..4096"));
  EXPECT_THAT(checked([](Page& p) { p.border_vertices = 5; }), HasSubstr("5 border vertices"));
  EXPECT_THAT(checked([](Page& p) { p.positions[1].x() = 1 << 24; }), HasSubstr("16777216"));
  EXPECT_THAT(checked([](Page& p) { p.positions[1].x() = -1; }), HasSubstr("vertex 1 lies at -1"));
  EXPECT_THAT(checked([](Page& p) { p.colours.resize(3); }), HasSubstr("3 colours"));
}

TEST(PageChecks, PatchesThatCannotBeAreNamed) {
  EXPECT_THAT(checked([](Page& p) { p.patches.clear(); }), HasSubstr("0 patches"));
  EXPECT_THAT(checked([](Page& p) { p.patches[0].triangles = 3; }), HasSubstr("3 triangles"));
  EXPECT_THAT(checked([](Page& p) {
                p.patches = {{kNoPage, 2}, {kNoPage, 0}};
              }),
              HasSubstr("2 patches of level 0"));
  EXPECT_THAT(checked([](Page& p) { p.patches = {{0, 2}}; }), HasSubstr("is not finer"));
  EXPECT_THAT(checked([](Page& p) {
                p.id = 9;
                p.patches = {{4, 1}, {4, 1}};
              }),
              HasSubstr("patch 1 replaces page 4"));
  EXPECT_THAT(checked([](Page& p) {
                p.id = 9;
                p.patches = {{4, 2}, {5, 0}};
              }),
              HasSubstr("patch 1 has no triangle"));
}

TEST(PageChecks, VerticesWithoutATriangleAndIndicesOutsideAreNamed) {
  EXPECT_THAT(checked([](Page& p) { p.triangles[1][2] = 0; }), HasSubstr("vertex 3 has no"));
  EXPECT_THAT(checked([](Page& p) { p.triangles[1][2] = 4; }), HasSubstr("vertex 4 of 4"));
}

TEST(PageChecks, NormalsOfAnotherLengthOrNumberAreNamed) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const float length : {0.0f, 2.0f, kNan})
    EXPECT_THAT(checked([&](Page& p) { p.normals[1] = Vec3f(0, length, 0); }),
                HasSubstr("normal of vertex 1"));
  EXPECT_THAT(checked([](Page& p) { p.normals.pop_back(); }), HasSubstr("1 normals"));
}

}  // namespace
}  // namespace burnish
