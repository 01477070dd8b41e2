// The pages that clients of a live session show.

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/page_frames/page_frame_decoder.h"
#include "server/library/scan_record.h"
#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Ann's session "work" on a sphere of several pages.
class LivePages : public LiveWork {
 protected:
  LivePages() {
    BURNISH_CHECK(library_.import(sphere_file(1, 5), "large").is_ok(), "import");
    BURNISH_CHECK(manager_->open({"large", "large", {6, 0}}, "ann", {}).is_ok(), "open");
  }
  LiveGuest large(const std::string& user = "ann", std::optional<PageFrameKind> kind = {}) {
    return guest(user, {"large", kind});
  }
  static std::vector<PageId> shown(LiveGuest& guest) {
    std::vector<PageId> pages;
    for (const PageTile& tile : guest.pages.state().tiles) pages.push_back(tile.shown.page);
    return pages;
  }
  static std::vector<int32_t> values_of_page(LiveGuest& guest, PageId page) {
    const PageTile& tile = *guest.pages.state().find(page);
    std::vector<int32_t> values(tile.value_count());
    tile.read(values);
    return values;
  }
  static Status show(LiveGuest& guest, const ShowPages& change) {
    return guest.subscriber().show_pages(change);
  }
};

TEST_F(LivePages, APageGetsItsValuesInTheFrameAfterItIsShown) {
  auto ann = large();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.show({0});
  ann.settle();
  const size_t frames = ann.frames.size();
  ann.show({3, 1}, {0});
  ann.settle();
  ASSERT_EQ(ann.frames.size(), frames + 1) << "the surface is still";
  EXPECT_EQ(ann.frames.back().revision, 2u);
  EXPECT_EQ(ann.frames.back().step_shift, 0);
  EXPECT_THAT(shown(ann), ElementsAre(1, 3));
  EXPECT_EQ(ann.pages.values(), sample(ann));
}

TEST_F(LivePages, FewerPagesAreANewRevisionWithoutValues) {
  auto ann = large();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.show({0, 1});
  ann.settle();
  ann.show({}, {0});
  ann.settle();
  EXPECT_EQ(ann.frames.back().revision, 2u);
  EXPECT_TRUE(ann.frames.back().changed_pages.empty());
  EXPECT_LT(ann.all<LiveFrame>().back().data.size(), 100u);
  EXPECT_EQ(ann.pages.values(), sample(ann));
}

TEST_F(LivePages, TwoClientsSeeTheSameAtAPageThatBothShow) {
  auto ann = large(), bob = large("bob");
  ann.show({0, 1, 2});
  bob.show({2, 5});
  ann.edit({{"a", stroke()}});
  for (LiveGuest* each : {&ann, &bob}) each->settle();
  EXPECT_EQ(values_of_page(ann, 2), values_of_page(bob, 2));
}

TEST_F(LivePages, ADabSendsOnlyPagesThatItTouches) {
  auto ann = large();
  ann.show_level(0);
  ann.settle();
  const Vec3d place(1, 0, 0);
  ann.edit({{"a", Stroke{{0.2, 1, 0, FallOff::kSmooth}, {place}}}});
  const size_t before = ann.frames.size();
  ann.settle();
  ASSERT_GT(ann.frames.size(), before);
  const uint32_t all = ann.pages.head().level_pages[0];
  for (size_t i = before; i < ann.frames.size(); ++i)
    EXPECT_LE(2 * ann.frames[i].changed_pages.size(), all) << "of frame " << i;
  const std::vector<int32_t> solved = sample(ann), seen = ann.pages.values();
  for (size_t i = 0; i < solved.size(); ++i)
    ASSERT_LE(std::abs(solved[i] - seen[i]), 1);  // held parts are less than half a step off
}

TEST_F(LivePages, APagesGainIsAboveTheLargestBetaInItsCells) {
  auto ann = large();
  ann.show_level(0);
  (void)ann.session().preview(ann.connection(), {"slide", SetGradientScale{3}});
  ann.settle();
  for (const PageTile& tile : ann.pages.state().tiles) EXPECT_EQ(tile.gain, 2);
  ann.session().drop_preview(ann.connection(), "slide");
  ann.settle();
  for (const PageTile& tile : ann.pages.state().tiles) EXPECT_EQ(tile.gain, 0);
}

TEST_F(LivePages, AWrongChangeIsRefusedAndNamesValueAndLimit) {
  auto ann = large(), bob = large("bob");
  const uint32_t pages = ann.pages.head().page_count();
  const std::pair<ShowPages, const char*> wrong[] = {{{2, {0}, {}}, "revision 2"},
                                                     {{1, {pages}, {}}, "is unknown"},
                                                     {{1, {0, 0}, {}}, "twice"},
                                                     {{1, {}, {0}}, "not shown"}};
  for (const auto& [change, text] : wrong) {
    const Status refused = show(ann, change);
    EXPECT_EQ(refused.code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(refused.message(), HasSubstr(text));
  }
  bob.show({0});
  bob.settle();
  EXPECT_EQ(bob.pages.values(), sample(bob));
}

TEST_F(LivePages, AtMost64ChangesWait) {
  auto ann = large();
  // Nobody takes turns, but encoders make pages meanwhile: so many changes that some must wait.
  Status last;
  uint32_t revision = 0;
  while (last.is_ok() && revision < 100'000)
    last = ++revision % 2 == 1 ? show(ann, {revision, {0, 1, 2, 3, 4, 5, 6, 7}, {}})
                               : show(ann, {revision, {}, {0, 1, 2, 3, 4, 5, 6, 7}});
  EXPECT_EQ(last.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(last.message(), HasSubstr("the limit is 64"));
}

TEST_F(LivePages, TheKindFollowsWhatIsShown) {
  ASSERT_TRUE(manager_->open({"large", "flat", {4, 0}}, "ann", {}).is_ok());
  auto coarse_grid = guest("ann", {"flat"}), fine_grid = large();
  for (LiveGuest* each : {&coarse_grid, &fine_grid}) {
    each->show_level(0);
    each->settle();
  }
  EXPECT_EQ(coarse_grid.pages.kind(), PageFrameKind::kCorners);
  EXPECT_EQ(fine_grid.pages.kind(), PageFrameKind::kVertices);
}

TEST_F(LivePages, TheKindChangesWithAKeyFrameWhenOtherPagesMakeItWorthIt) {
  ASSERT_TRUE(manager_->open({"large", "flat", {4, 0}}, "ann", {}).is_ok());
  auto ann = guest("ann", {"flat"});
  const PageId root = ann.pages.head().root();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.show_level(0);
  ann.settle();
  ASSERT_EQ(ann.pages.kind(), PageFrameKind::kCorners);
  const uint64_t before = ann.frames.back().sequence;
  std::vector<PageId> fine = shown(ann);
  ann.show({root}, fine);  // its vertices are further apart than the cells
  ann.settle();
  EXPECT_EQ(ann.pages.kind(), PageFrameKind::kVertices);
  EXPECT_TRUE(ann.frames.back().is_key);
  EXPECT_GT(ann.frames.back().sequence, before);
  EXPECT_EQ(ann.pages.values(), sample(ann));
}

TEST_F(LivePages, AHiddenPageGivesItsMemoryBack) {
  Quota& memory = manager_->memory();
  auto ann = large();
  ann.show({1});
  ann.settle();
  const uint64_t before = memory.taken();
  ann.show({0});
  ann.settle();
  EXPECT_GT(memory.taken(), before);
  ann.show({}, {0});
  // The frames that had the page are forgotten when later ones are acknowledged.
  for (const double beta : {0.5, 0.25, 0.0}) {
    ASSERT_TRUE(ann.session().preview(ann.connection(), {"slide", SetGradientScale{beta}}).is_ok());
    ann.settle();
  }
  EXPECT_EQ(memory.taken(), before);
}

TEST_F(LivePages, ADamagedPageFileEndsTheStreamAndIsMadeAgain) {
  const std::string id = library_.store->find("large").value().id;
  const auto path = library_.folder->scans() / id / pages_file_name();
  auto ann = large();
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(100);
    file.put('\xff');
    file.put('\xff');
  }
  ASSERT_TRUE(show(ann, {1, {0}, {}}).is_ok());
  ann.run();
  const auto go_aways = ann.all<GoAway>();
  ASSERT_EQ(go_aways.size(), 1u);
  EXPECT_THAT(go_aways[0].reason, HasSubstr("page 0"));
  EXPECT_EQ(go_aways[0].code, GoAwayCode::kDamagedPages);
  EXPECT_TRUE(go_aways[0].come_back);
  auto again = large();
  again.show({0});
  again.settle();
  EXPECT_EQ(again.pages.values(), sample(again));
  EXPECT_EQ(again.welcome.pages_fingerprint, ann.welcome.pages_fingerprint);
}

}  // namespace
}  // namespace burnish
