#include "client/live/pages_to_show.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/page_frames/page_frame_decoder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr uint32_t kScanPages = 100;

std::vector<std::shared_ptr<const Page>> numbered_pages(const std::vector<PageId>& ids) {
  std::vector<std::shared_ptr<const Page>> pages;
  for (const PageId id : ids) {
    auto page = std::make_shared<Page>();
    page->id = id;
    pages.push_back(std::move(page));
  }
  return pages;
}

void change(PagesToShow& pages, const std::vector<PageId>& added,
            const std::vector<PageId>& removed = {}) {
  const Status status = pages.change(numbered_pages(added), removed);
  EXPECT_TRUE(status.is_ok()) << status.message();
}

TEST(PagesToShow, SayEachChangeOnce) {
  PagesToShow pages(kScanPages);
  EXPECT_FALSE(pages.next());
  change(pages, {5, 2});
  const auto first = pages.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->revision, 1u);
  EXPECT_THAT(first->added, ElementsAre(2, 5));
  EXPECT_FALSE(pages.next());
  change(pages, {3}, {2});
  const auto second = pages.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->revision, 2u);
  EXPECT_THAT(second->added, ElementsAre(3));
  EXPECT_THAT(second->removed, ElementsAre(2));
}

TEST(PagesToShow, MergeChangesThatWait) {
  PagesToShow pages(kScanPages);
  change(pages, {1, 2});
  change(pages, {3}, {1});
  change(pages, {1}, {2});
  const auto merged = pages.next();
  ASSERT_TRUE(merged);
  EXPECT_THAT(merged->added, ElementsAre(1, 3));
  EXPECT_THAT(merged->removed, IsEmpty());
  change(pages, {}, {3});
  change(pages, {3});
  EXPECT_FALSE(pages.next());
}

TEST(PagesToShow, WaitWhileNoFrameShowsTheChangesBefore) {
  PagesToShow pages(kScanPages);
  for (PageId page = 0; page < kPageChangesInFlightMax; ++page) {
    change(pages, {page});
    ASSERT_TRUE(pages.next());
  }
  change(pages, {80});
  change(pages, {81});
  EXPECT_FALSE(pages.next());
  pages.shown(1);
  const auto merged = pages.next();
  ASSERT_TRUE(merged);
  EXPECT_EQ(merged->revision, kPageChangesInFlightMax + 1);
  EXPECT_THAT(merged->added, ElementsAre(80, 81));
}

TEST(PagesToShow, SayAllToANewStream) {
  PagesToShow pages(kScanPages);
  change(pages, {1, 2});
  ASSERT_TRUE(pages.next());
  pages.shown(1);
  change(pages, {4}, {1});
  pages.restart();
  const auto all = pages.next();
  ASSERT_TRUE(all);
  EXPECT_EQ(all->revision, 1u);
  EXPECT_THAT(all->added, ElementsAre(2, 4));
  EXPECT_THAT(all->removed, IsEmpty());
}

TEST(PagesToShow, RefuseWrongChangesWithoutEffect) {
  PagesToShow pages(kScanPages);
  change(pages, {1});
  const auto wrong = [&](const std::vector<PageId>& added, const std::vector<PageId>& removed) {
    return pages.change(numbered_pages(added), removed);
  };
  EXPECT_EQ(wrong({1}, {}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(wrong({2, 2}, {}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(wrong({}, {7}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(wrong({3, kScanPages}, {}).code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(wrong({kScanPages}, {}).message(), HasSubstr("100"));
  EXPECT_THAT(pages.next()->added, ElementsAre(1));
}

TEST(PagesToShow, RefuseMorePagesThanAClientMayShow) {
  PagesToShow pages(2 * kShownPagesMax);
  std::vector<PageId> many;
  for (PageId page = 0; page <= kShownPagesMax; ++page) many.push_back(page);
  const Status status = pages.change(numbered_pages(many), {});
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr(std::to_string(kShownPagesMax)));
}

TEST(PagesToShow, KeepThePagesThatAreWanted) {
  PagesToShow pages(kScanPages);
  const auto held = numbered_pages({7});
  ASSERT_TRUE(pages.change(held, {}).is_ok());
  const std::vector<PageId> wanted = {7};
  EXPECT_THAT(pages.find(wanted), ElementsAre(held[0]));
}

}  // namespace
}  // namespace burnish
