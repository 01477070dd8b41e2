#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/grid/sparse_grid.h"
#include "common/view/view.h"
#include "common/view/view_format.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr uint64_t kRoom = uint64_t{256} << 20;

/// Returns correct parts: two cells, one triangle with a vertex in no cell, colours.
ViewParts tiny_parts() {
  return {.frame = {Vec3d(1, 2, 3), 0.5, 4},
          .length_unit = 2,
          .scan_vertices = 3,
          .scan_triangles = 1,
          .cells = {5, 9},
          .triangles = {{0, 1, 2}},
          .homes = {0, 1, kNone},
          .locals = {{0, 0.5f, 1}, {0.25f, 0.25f, 0.25f}, {0, 0, 0}},
          .strays = {{7, 8, 9}},
          .colours = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}};
}

/// Returns the status of reading after `spoil` has changed the parts and all is sealed again.
template <typename Spoil>
Status spoilt(Spoil spoil) {
  ViewParts parts = tiny_parts();
  spoil(parts);
  return read_view(pack_view(parts), kRoom).status();
}

TEST(HostileView, ThePartsBeforeTheyAreSpoiltAreGood) {
  EXPECT_TRUE(spoilt([](ViewParts&) {}).is_ok());
}

TEST(HostileView, EveryChangedByteIsNoticed) {
  const std::vector<uint8_t> good = pack_view(tiny_parts());
  for (size_t i = 0; i < good.size(); ++i) {
    std::vector<uint8_t> bad = good;
    bad[i] ^= 0x10;
    EXPECT_FALSE(read_view(bad, kRoom).is_ok()) << i;
  }
}

TEST(HostileView, EveryShorterFileIsRefused) {
  const std::vector<uint8_t> good = pack_view(tiny_parts());
  for (size_t size = 0; size < good.size(); ++size)
    EXPECT_EQ(read_view(std::span(good).first(size), kRoom).status().code(), StatusCode::kDataLoss)
        << size;
}

TEST(HostileView, BytesBehindTheEndAreRefused) {
  std::vector<uint8_t> bytes = pack_view(tiny_parts());
  bytes.push_back(0);
  EXPECT_EQ(read_view(bytes, kRoom).status().code(), StatusCode::kDataLoss);
}

TEST(HostileView, AnotherVersionIsUnimplemented) {
  std::vector<uint8_t> bytes = pack_view(tiny_parts());
  bytes[4] = 2;
  EXPECT_EQ(read_view(bytes, kRoom).status().code(), StatusCode::kUnimplemented);
}

TEST(HostileView, MoreMemoryThanThereIsRoomForIsRefusedWithBothNumbers) {
  const Status status = read_view(pack_view(tiny_parts()), 1000).status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("takes 1536 bytes of memory, the limit is 1000"));
}

TEST(HostileView, ScalarsOutsideTheirLimitsAreNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const int depth : {0, 3, 13, 255})
    EXPECT_THAT(spoilt([&](ViewParts& p) { p.frame.depth = depth; }).message(),
                HasSubstr("depth " + std::to_string(depth)));
  for (const double size : {0.0, -1.0, kNan, 1e300})
    EXPECT_THAT(spoilt([&](ViewParts& p) { p.frame.cell_size = size; }).message(),
                HasSubstr("cell size"));
  for (const double length : {0.0, kNan})
    EXPECT_THAT(spoilt([&](ViewParts& p) { p.length_unit = length; }).message(),
                HasSubstr("length unit"));
  for (const double origin : {kNan, 1e300})
    EXPECT_THAT(spoilt([&](ViewParts& p) { p.frame.origin.y() = origin; }).message(),
                HasSubstr("origin"));
}

TEST(HostileView, CellsOutsideTheGridOrOutOfOrderAreNamed) {
  EXPECT_THAT(spoilt([](ViewParts& p) { p.cells[1] = 4096; }).message(),
              HasSubstr("cell 1 is outside the grid of depth 4"));
  EXPECT_THAT(spoilt([](ViewParts& p) { p.cells[1] = 5; }).message(),
              HasSubstr("the key of cell 1 is not above"));
}

TEST(HostileView, IndicesBeyondTheEndAreNamed) {
  EXPECT_THAT(spoilt([](ViewParts& p) { p.triangles[0][1] = 3; }).message(),
              HasSubstr("triangle 0 refers to vertex 3 of 3"));
  EXPECT_THAT(spoilt([](ViewParts& p) { p.homes[1] = 2; }).message(),
              HasSubstr("vertex 1 lies in cell 2 of 2"));
  EXPECT_THAT(spoilt([](ViewParts& p) { p.homes[1] = -2; }).message(),
              HasSubstr("vertex 1 lies in cell -2"));
}

TEST(HostileView, PlacesOutsideTheCellAndWildPositionsAreNamed) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const float local : {-0.1f, 1.1f, kNan})
    EXPECT_THAT(spoilt([&](ViewParts& p) { p.locals[1][2] = local; }).message(),
                HasSubstr("vertex 1 lies at"));
  for (const double wild : {1e19, std::numeric_limits<double>::infinity()})
    EXPECT_THAT(spoilt([&](ViewParts& p) { p.strays[0][0] = wild; }).message(),
                HasSubstr("a vertex in no cell lies at"));
}

TEST(HostileView, SectionsOfDifferentLengthsAreNamed) {
  EXPECT_THAT(spoilt([](ViewParts& p) { p.locals.pop_back(); }).message(),
              HasSubstr("section locals has 2 elements, not 3"));
  EXPECT_THAT(spoilt([](ViewParts& p) { p.strays.clear(); }).message(),
              HasSubstr("section strays has 0 elements, not 1"));
  EXPECT_THAT(spoilt([](ViewParts& p) { p.colours.pop_back(); }).message(),
              HasSubstr("section colours has 2 elements, not 3"));
  EXPECT_THAT(spoilt([](ViewParts& p) { p.scan_triangles = 0; }).message(),
              HasSubstr("has more vertices or triangles than its scan"));
}

// Changes headers and sections at random; seals each as if it were good.
TEST(HostileView, RandomPartsNeverCrash) {
  std::mt19937 random(11);
  int good = 0;
  for (int run = 0; run < 3000; ++run) {
    ViewParts parts = tiny_parts();
    const auto dice = [&random](int sides) { return static_cast<int>(random() % sides); };
    parts.frame.depth = dice(20);
    for (int change = 0; change < 3; ++change) switch (dice(6)) {
        case 0:
          parts.cells[dice(2)] = random() >> dice(32);
          break;
        case 1:
          parts.triangles[0][dice(3)] = random() >> dice(32);
          break;
        case 2:
          parts.homes[dice(3)] = dice(4) - 2;
          break;
        case 3:
          parts.locals[dice(3)][dice(3)] = static_cast<float>(dice(5)) - 1;
          break;
        case 4:
          parts.cells.push_back(10 + random() % 5000);
          break;
        default:
          parts.homes.resize(3 + dice(2), 0);
      }
    good += read_view(pack_view(parts), kRoom).is_ok() ? 1 : 0;
  }
  EXPECT_GT(good, 0);
}

}  // namespace
}  // namespace burnish
