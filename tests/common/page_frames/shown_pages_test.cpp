#include "common/page_frames/shown_pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr uint32_t kPages = 100;

std::vector<ShownPage> pages_of(const std::vector<PageId>& numbers) {
  std::vector<ShownPage> pages;
  for (const PageId number : numbers) pages.push_back(plain_page(number, 10 * number));
  return pages;
}

ShownPages showing_numbers(const std::vector<PageId>& pages) {
  return ShownPages().changed({.revision = 1, .added = pages_of(pages)});
}

TEST(ShownPages, BeginWithNothingAtRevisionZero) {
  EXPECT_EQ(ShownPages().revision(), 0u);
  EXPECT_TRUE(ShownPages().pages().empty());
}

TEST(ShownPages, ColoursOfAPageHaveANumberOfTheirOwn) {
  const ShownPages shown = showing_numbers({9});
  const auto with = [](PageId page) {
    return PageChange{.revision = 2, .added = pages_of({page}), .removed = {}};
  };
  EXPECT_TRUE(shown.check(with(9 | kColourPages), kPages).is_ok());
  EXPECT_THAT(shown.check(with(kPages | kColourPages), kPages).message(),
              HasSubstr("colours of page 100 is unknown"));
  EXPECT_EQ(page_in_file(9 | kColourPages), 9u);
}

TEST(ShownPages, AreSortedWhateverTheOrderOfAChange) {
  const ShownPages shown = showing_numbers({9, 2, 5}).changed(
      {.revision = 2, .added = pages_of({7, 1}), .removed = {5}});
  EXPECT_EQ(shown.revision(), 2u);
  std::vector<PageId> numbers;
  for (const ShownPage& page : shown.pages()) {
    numbers.push_back(page.page);
    EXPECT_EQ(page.value_count(), 10 * page.page);
  }
  EXPECT_THAT(numbers, ElementsAre(1, 2, 7, 9));
  EXPECT_TRUE(shown.shows(7));
  EXPECT_FALSE(shown.shows(5));
}

TEST(ShownPages, ARevisionThatDoesNotFollowIsRefused) {
  for (const uint32_t revision : {0u, 1u, 3u}) {
    const Status status = showing_numbers({}).check({.revision = revision}, kPages);
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(status.message(), HasSubstr("must be 2"));
  }
  EXPECT_TRUE(showing_numbers({}).check({.revision = 2}, kPages).is_ok());
}

TEST(ShownPages, AnUnknownPageIsRefused) {
  const Status status = ShownPages().check({.revision = 1, .added = {{kPages, {}}}}, kPages);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("page 100 is unknown: the scan has 100"));
}

TEST(ShownPages, APageThatIsShownCannotBeAdded) {
  EXPECT_THAT(showing_numbers({7}).check({.revision = 2, .added = {{7, {}}}}, kPages).message(),
              HasSubstr("page 7 is shown already"));
}

TEST(ShownPages, APageThatIsNotShownCannotBeRemoved) {
  EXPECT_THAT(showing_numbers({7}).check({.revision = 2, .removed = {8}}, kPages).message(),
              HasSubstr("page 8 is removed but not shown"));
}

TEST(ShownPages, AChangeNamesAPageOnce) {
  const ShownPages shown = showing_numbers({7});
  for (const PageChange& change : {PageChange{2, pages_of({3, 3}), {}}, PageChange{2, {}, {7, 7}},
                                   PageChange{2, pages_of({7}), {7}}})
    EXPECT_THAT(shown.check(change, kPages).message(), HasSubstr("named twice"));
}

TEST(ShownPages, TooManyPagesAreRefused) {
  PageChange change{.revision = 1};
  for (PageId page = 0; page < kShownPagesMax; ++page) change.added.push_back({page, {}});
  EXPECT_TRUE(ShownPages().check(change, kPagesMax).is_ok());
  change.added.push_back({kShownPagesMax, {}});
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
