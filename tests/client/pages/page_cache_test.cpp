#include "client/pages/page_cache.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr size_t kBytes = 10'000;
constexpr size_t kVertices = 10'000;  // 120 KB of positions

std::shared_ptr<const Page> decoded_page() {
  Page page;
  page.positions.resize(kVertices);
  return std::make_shared<const Page>(std::move(page));
}

void bring(PageCache& cache, PageId page) {
  ASSERT_TRUE(cache.hold(page, std::vector<uint8_t>(kBytes)));
  ASSERT_TRUE(cache.decode(page, decoded_page()));
}

PageBudget budget_of(uint64_t resident_bytes, uint64_t slots) {
  return {.resident_bytes = resident_bytes, .card_bytes = slots * kSlotBytes};
}

TEST(PageCache, APageComesInSteps) {
  PageCache cache({});
  EXPECT_EQ(cache.state_of(5), PageState::kAbsent);
  EXPECT_TRUE(cache.hold(5, std::vector<uint8_t>(kBytes)));
  EXPECT_EQ(cache.state_of(5), PageState::kHeld);
  EXPECT_TRUE(cache.decode(5, decoded_page()));
  EXPECT_EQ(cache.state_of(5), PageState::kDecoded);
  EXPECT_TRUE(cache.place(5));
  EXPECT_EQ(cache.state_of(5), PageState::kOnCard);
  EXPECT_EQ(cache.find(5)->slot, 0u);
}

TEST(PageCache, DroppingAPageGivesAllBack) {
  PageCache cache({});
  bring(cache, 5);
  cache.place(5);
  cache.drop(5);
  EXPECT_EQ(cache.resident_bytes(), 0u);
  EXPECT_EQ(cache.slots().taken(), 0u);
  EXPECT_EQ(cache.page_count(), 0u);
}

TEST(PageCache, TheLongestUnusedPageLosesItsDecodedFormFirst) {
  PageCache cache(budget_of(450'000, 10));
  for (const PageId page : {1, 2, 3}) bring(cache, page);
  cache.begin_picture();
  cache.use(1);
  cache.begin_picture();
  bring(cache, 4);
  EXPECT_EQ(cache.state_of(2), PageState::kHeld);
  EXPECT_EQ(cache.state_of(1), PageState::kDecoded);
  EXPECT_EQ(cache.state_of(3), PageState::kDecoded);
  EXPECT_EQ(cache.page_count(), 4u);
}

TEST(PageCache, BytesGoWhenNoDecodedPageIsLeftToTake) {
  PageCache cache(budget_of(60'000, 10));
  for (const PageId page : {1, 2, 3, 4, 5}) cache.hold(page, std::vector<uint8_t>(kBytes));
  cache.begin_picture();
  cache.use(1);
  EXPECT_TRUE(cache.hold(6, std::vector<uint8_t>(kBytes)));
  EXPECT_EQ(cache.state_of(2), PageState::kAbsent);
  EXPECT_EQ(cache.state_of(1), PageState::kHeld);
}

TEST(PageCache, WhatThePictureUsesIsNeverTaken) {
  PageCache cache(budget_of(450'000, 2));
  for (const PageId page : {1, 2, 3}) bring(cache, page);
  cache.place(1);
  cache.place(2);
  cache.begin_picture();
  for (const PageId page : {1, 2, 3}) cache.use(page);
  EXPECT_FALSE(cache.place(3));
  EXPECT_TRUE(cache.hold(4, std::vector<uint8_t>(kBytes)));
  EXPECT_FALSE(cache.decode(4, decoded_page()));
  EXPECT_EQ(cache.state_of(4), PageState::kHeld);
  EXPECT_EQ(cache.state_of(1), PageState::kOnCard);
  EXPECT_LE(cache.resident_bytes(), 450'000u);
}

TEST(PageCache, AnUnusedPageGivesItsSlotAndStaysDecoded) {
  PageCache cache(budget_of(450'000, 1));
  bring(cache, 1);
  bring(cache, 2);
  cache.place(1);
  cache.begin_picture();
  cache.use(2);
  EXPECT_TRUE(cache.place(2));
  EXPECT_EQ(cache.state_of(1), PageState::kDecoded);
  EXPECT_EQ(cache.find(2)->slot, 0u);
}

}  // namespace
}  // namespace burnish
