#include "client/surface/shown_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/page_frames/shown_pages.h"
#include "tests/client/pages/synthetic_scan.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A cut that uses some pages of a scan, and the cache that has them.
class ShownSetTest : public testing::Test {
 protected:
  ShownSetTest() : cache_(PageBudget()) {
    for (PageId page = 0; page <= root(); ++page) decode(page);
  }
  PageId root() const { return scan_.directory.head.root(); }
  void decode(PageId page) {
    cache_.hold(page, {1});
    cache_.decode(page, std::make_shared<const Page>(scan_.page(page)));
  }
  uint64_t vertices(PageId page) const { return scan_.directory.entries[page].vertices; }

  /// Pages from fine to coarse, as the chooser lists them.
  static ChosenCut cut_of(std::vector<PageId> used) {
    ChosenCut cut;
    for (const PageId page : used) cut.used.push_back({.page = page});
    return cut;
  }
  static SurfaceFrame frame_of(std::vector<PageId> pages) {
    SurfaceFrame frame;
    frame.moves.assign(pages.size(), std::make_shared<const PageMove>());
    frame.pages = std::move(pages);
    return frame;
  }
  static std::vector<PageId> ids(const std::vector<std::shared_ptr<const Page>>& pages) {
    std::vector<PageId> ids;
    for (const auto& page : pages) ids.push_back(page->id);
    return ids;
  }

  SyntheticScan scan_ = make_synthetic_scan({});
  PageCache cache_;
  ShownSet shown_;
};

TEST_F(ShownSetTest, DecodedPagesOfTheCutAreShownOnceCoarseBeforeFine) {
  const ChosenCut cut = cut_of({0, 1, root()});
  EXPECT_THAT(ids(shown_.change(cut, cache_, nullptr, 0).added), ElementsAre(root(), 1, 0));
  EXPECT_TRUE(shown_.change(cut, cache_, nullptr, 0).is_empty());
}

TEST_F(ShownSetTest, ColoursComeBehindTheirPagesAndGoWhenNobodyLooks) {
  Page coloured = scan_.page(1);
  coloured.colours.resize(coloured.positions.size());
  cache_.drop(1);
  cache_.hold(1, {1});
  cache_.decode(1, std::make_shared<const Page>(coloured));
  const ChosenCut cut = cut_of({1, root()});
  shown_.show_colours(true);
  EXPECT_THAT(ids(shown_.change(cut, cache_, nullptr, 0).added),
              ElementsAre(root(), 1, 1 | kColourPages));  // the root has none
  EXPECT_EQ(shown_.page_count(), 3u);
  EXPECT_EQ(shown_.copies(), 2u);
  shown_.show_gains(true);
  EXPECT_THAT(ids(shown_.change(cut, cache_, nullptr, 0).added), ElementsAre(1 | kGainPages));
  EXPECT_EQ(shown_.copies(), 3u);
  shown_.show_colours(false);
  EXPECT_TRUE(shown_.change(cut, cache_, nullptr, 0).added.empty());
  EXPECT_EQ(shown_.copies(), 1u) << "texels without colours need no gains";
}

TEST_F(ShownSetTest, APageThatIsNotDecodedWaits) {
  cache_.drop(1);
  EXPECT_THAT(ids(shown_.change(cut_of({1, root()}), cache_, nullptr, 0).added),
              ElementsAre(root()));
  decode(1);
  EXPECT_THAT(ids(shown_.change(cut_of({1, root()}), cache_, nullptr, 0).added), ElementsAre(1));
}

TEST_F(ShownSetTest, ASlowLinkGetsAsManyNewVerticesAsItTakes) {
  const uint64_t limit = vertices(root()) + vertices(2);
  const ChosenCut cut = cut_of({0, 1, 2, root()});
  EXPECT_THAT(ids(shown_.change(cut, cache_, nullptr, limit).added), ElementsAre(root(), 2));
  EXPECT_TRUE(shown_.change(cut, cache_, nullptr, limit).is_empty()) << "they are on their way";
  const SurfaceFrame frame = frame_of({2, root()});
  EXPECT_THAT(ids(shown_.change(cut, cache_, &frame, limit).added), ElementsAre(1, 0));
}

TEST_F(ShownSetTest, APageLargerThanTheLimitStillComes) {
  EXPECT_THAT(ids(shown_.change(cut_of({root()}), cache_, nullptr, 1).added), ElementsAre(root()));
}

TEST_F(ShownSetTest, AFewUnneededPagesStayAndManyGo) {
  shown_.change(cut_of({0, 1, 2, root()}), cache_, nullptr, 0);
  EXPECT_THAT(shown_.change(cut_of({root()}), cache_, nullptr, 0).removed, IsEmpty());
  std::vector<PageId> many;
  for (PageId page = 0; page < 40; ++page) many.push_back(page);
  many.push_back(root());
  shown_.change(cut_of(many), cache_, nullptr, 0);
  EXPECT_EQ(shown_.change(cut_of({root()}), cache_, nullptr, 0).removed.size(), 40u);
  EXPECT_EQ(shown_.page_count(), 1u);
}

TEST_F(ShownSetTest, NoUnneededPageStaysWhereAServerRefusedSoMany) {
  shown_.change(cut_of({0, 1, 2, root()}), cache_, nullptr, 0);
  const uint64_t all = shown_.vertex_count();
  EXPECT_THAT(shown_.change(cut_of({root()}), cache_, nullptr, 0, all).removed, IsEmpty());
  EXPECT_EQ(shown_.change(cut_of({root()}), cache_, nullptr, 0, all / 2).removed.size(), 3u);
  EXPECT_EQ(shown_.vertex_count(), vertices(root()));
}

}  // namespace
}  // namespace burnish
