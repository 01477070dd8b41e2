#include "common/pages/directory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/pages/made_pages.h"
#include "tests/common/pages/made_scan.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(PageHead, PagesAreNumberedFromFineToCoarse) {
  const PageHead head = made_directory().head;
  EXPECT_EQ(head.page_count(), 303u);
  EXPECT_EQ(head.root(), 302u);
  EXPECT_EQ(head.level_begin(1), 300u);
  EXPECT_EQ(head.level_begin(3), 303u);
  EXPECT_EQ(head.level_of(0), 0);
  EXPECT_EQ(head.level_of(299), 0);
  EXPECT_EQ(head.level_of(300), 1);
  EXPECT_EQ(head.level_of(302), 2);
}

TEST(PageHead, BlocksDoNotCrossLevels) {
  const PageHead head = made_directory().head;
  ASSERT_EQ(head.block_count(), 4u);
  EXPECT_EQ(head.pages_of(0).end, 256u);
  EXPECT_EQ(head.pages_of(1).begin, 256u);
  EXPECT_EQ(head.pages_of(1).end, 300u);
  EXPECT_EQ(head.pages_of(2).count(), 2u);
  EXPECT_EQ(head.pages_of(3).begin, 302u);
  for (PageId page = 0; page < head.page_count(); ++page) {
    const PageRange pages = head.pages_of(head.block_of(page));
    EXPECT_TRUE(pages.begin <= page && page < pages.end) << page;
  }
}

TEST(PageHead, JoinedBoundsHoldEachOfThem) {
  const auto entries = made_directory().entries;
  const PageBounds joined = join_bounds(entries);
  for (const PageEntry& entry : entries) {
    EXPECT_LE((entry.bounds.centre - joined.centre).norm() + entry.bounds.radius, joined.radius);
    EXPECT_LE(entry.bounds.error, joined.error);
    EXPECT_LE(entry.bounds.edge, joined.edge);
  }
}

TEST(PageGrid, APositionIsInTheCellOfItsPointAtEveryDepth) {
  const PageGrid grid{{-5, 10, 0.25}, 3, 20};
  for (int i = 0; i < 1000; ++i) {
    const Vec3d point = grid.origin + Vec3d(0.0029 * i, 0.0017 * i, 3 - 0.003 * i);
    const Vec3i position = grid.quantise(point);
    for (int depth = 4; depth <= 12; ++depth) {
      const Vec3d cell = (point - grid.origin) / (grid.side / (1 << depth));
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(position[axis] >> (grid.bits - depth),
                  std::min(static_cast<int>(cell[axis]), (1 << depth) - 1));
    }
    EXPECT_LT((grid.to_file(position) - point).cwiseAbs().maxCoeff(), grid.step());
  }
}

TEST(PageGrid, PointsOutsideTheCubeTakeItsRim) {
  const PageGrid grid{{0, 0, 0}, 1, 8};
  EXPECT_EQ(grid.quantise({-1, 2, 1}), Vec3i(0, 255, 255));
}

/// Returns what check_page_in_scan() says of page 300 of the made directory.
template <typename Spoil>
std::string checked(Spoil spoil) {
  Page page = made_sheet({.id = 300, .patches = 2, .has_colours = false}, 1);
  spoil(page);
  return check_page_in_scan(page, 300, made_directory().head).message();
}

TEST(PageInScan, WhatDoesNotFitTheScanIsNamed) {
  EXPECT_EQ(checked([](Page&) {}), "");
  EXPECT_THAT(checked([](Page& p) { p.id = 301; }), HasSubstr("those of page 301"));
  EXPECT_THAT(checked([](Page& p) { p.positions[3].z() = 65536; }), HasSubstr("65536"));
  EXPECT_THAT(checked([](Page& p) { p.colours.resize(64); }), HasSubstr("has colours"));
  EXPECT_THAT(checked([](Page& p) { p.patches[1].finer = 301; }), HasSubstr("page 301"));
  EXPECT_THAT(checked([](Page& p) { p.patches[1].finer = kNoPage; }), HasSubstr("0..300"));
}

TEST(PageInScan, APageOfLevelZeroReplacesNoPage) {
  const PageHead head = made_directory().head;
  Page page = made_sheet({.id = 7, .patches = 0, .has_colours = false}, 1);
  EXPECT_TRUE(check_page_in_scan(page, 7, head).is_ok());
  page.patches[0].finer = 3;
  EXPECT_FALSE(check_page_in_scan(page, 7, head).is_ok());
}

TEST(PageInDirectory, AnEntryOfAnotherSizeOrAnUnknownPatchIsNamed) {
  PageDirectory directory = made_directory();
  const Page page = made_sheet({.id = 300, .patches = 2, .has_colours = false}, 1);
  EXPECT_THAT(check_page_in_directory(page, 300, directory).message(), HasSubstr("its entry says"));
  directory.entries[300].vertices = static_cast<uint16_t>(page.positions.size());
  directory.entries[300].triangles = static_cast<uint16_t>(page.triangles.size());
  EXPECT_TRUE(check_page_in_directory(page, 300, directory).is_ok());
  for (PageId& coarser : directory.coarser.item) coarser = std::max<PageId>(coarser, 301);
  EXPECT_THAT(check_page_in_directory(page, 300, directory).message(), HasSubstr("is not among"));
}

}  // namespace
}  // namespace burnish
