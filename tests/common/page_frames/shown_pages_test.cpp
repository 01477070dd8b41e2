#include "common/page_frames/shown_pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr uint32_t kPages = 100;

ShownPages showing(const std::vector<ShownPage>& pages) {
  return ShownPages().changed({.revision = 1, .added = pages});
}

TEST(ShownPages, BeginWithNothingAtRevisionZero) {
  EXPECT_EQ(ShownPages().revision(), 0u);
  EXPECT_TRUE(ShownPages().pages().empty());
}

TEST(ShownPages, AreSortedWhateverTheOrderOfAChange) {
  const ShownPages shown =
      showing({{9, 90}, {2, 20}, {5, 50}})
          .changed({.revision = 2, .added = {{7, 70}, {1, 10}}, .removed = {5}});
  EXPECT_EQ(shown.revision(), 2u);
  EXPECT_THAT(shown.pages(),
              ElementsAre(ShownPage{1, 10}, ShownPage{2, 20}, ShownPage{7, 70}, ShownPage{9, 90}));
  EXPECT_TRUE(shown.shows(7));
  EXPECT_FALSE(shown.shows(5));
}

TEST(ShownPages, ARevisionThatDoesNotFollowIsRefused) {
  for (const uint32_t revision : {0u, 1u, 3u}) {
    const Status status = showing({}).check({.revision = revision}, kPages);
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(status.message(), HasSubstr("must be 2"));
  }
  EXPECT_TRUE(showing({}).check({.revision = 2}, kPages).is_ok());
}

TEST(ShownPages, AnUnknownPageIsRefused) {
  const Status status = ShownPages().check({.revision = 1, .added = {{kPages, 1}}}, kPages);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("page 100 is unknown: the scan has 100"));
}

TEST(ShownPages, APageThatIsShownCannotBeAdded) {
  EXPECT_THAT(showing({{7, 1}}).check({.revision = 2, .added = {{7, 1}}}, kPages).message(),
              HasSubstr("page 7 is shown already"));
}

TEST(ShownPages, APageThatIsNotShownCannotBeRemoved) {
  EXPECT_THAT(showing({{7, 1}}).check({.revision = 2, .removed = {8}}, kPages).message(),
              HasSubstr("page 8 is removed but not shown"));
}

TEST(ShownPages, AChangeNamesAPageOnce) {
  const ShownPages shown = showing({{7, 1}});
  for (const PageChange& change : {PageChange{2, {{3, 1}, {3, 1}}, {}}, PageChange{2, {}, {7, 7}},
                                   PageChange{2, {{7, 1}}, {7}}})
    EXPECT_THAT(shown.check(change, kPages).message(), HasSubstr("named twice"));
}

TEST(ShownPages, TooManyPagesAreRefused) {
  PageChange change{.revision = 1};
  for (PageId page = 0; page < kShownPagesMax; ++page) change.added.push_back({page, 1});
  EXPECT_TRUE(ShownPages().check(change, kPagesMax).is_ok());
  change.added.push_back({kShownPagesMax, 1});
  const Status status = ShownPages().check(change, kPagesMax);
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("4097 pages are shown, the limit is 4096"));
}

TEST(ShownPages, AChangeOfTooManyNamesIsRefusedBeforeItIsSorted) {
  PageChange change{.revision = 1};
  change.removed.assign(2 * kShownPagesMax + 1, 0);
  EXPECT_EQ(ShownPages().check(change, kPagesMax).code(), StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace burnish
