#include "client/pages/page_requests.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr uint32_t kPartBytes = 10'000;
constexpr LinkSpeed kUnknownLink = {};

std::vector<MissingItem> pages(PageId begin, PageId end) {
  std::vector<MissingItem> missing;
  for (PageId page = begin; page < end; ++page)
    missing.push_back({PageItem::of_page(page), kPartBytes, static_cast<float>(page)});
  return missing;
}

bool wants_all(PageItem) {
  return true;
}

class PageRequestsAt : public testing::Test {
 protected:
  const PageRequests::Plan& plan(std::vector<MissingItem> missing,
                                 const LinkSpeed& link = kUnknownLink,
                                 const std::function<bool(PageItem)>& is_wanted = wants_all) {
    requests_.make_plan(missing, link, now_, is_wanted);
    return requests_.plan();
  }

  PageRequests requests_;
  PageRequests::Time now_ = {};
};

TEST_F(PageRequestsAt, TheMostUrgentAreAskedForFirstAndSixtyFourKilobytesOnAnUnknownLink) {
  const auto& asked = plan(pages(0, 100)).ask;
  ASSERT_EQ(asked.size(), 6u);
  for (uint32_t i = 0; i < asked.size(); ++i) EXPECT_EQ(asked[i], PageItem::of_page(99 - i));
  EXPECT_EQ(requests_.bytes_in_flight(), 60'000u);
}

TEST_F(PageRequestsAt, TwoRoundTripsAreInFlightOnAKnownLink) {
  EXPECT_EQ(bytes_in_flight_max({6.25e6, 0.04}), 500'000u);
  EXPECT_EQ(plan(pages(0, 100), {6.25e6, 0.04}).ask.size(), 50u);
}

TEST_F(PageRequestsAt, WhatComesUntilTheNextPlanIsInFlightToo) {
  const LinkSpeed link = {6.25e6, 0.04};
  now_ += std::chrono::hours(1);
  plan(pages(0, 1000), link);
  EXPECT_LE(requests_.bytes_in_flight(), bytes_in_flight_max(link));
  now_ += std::chrono::milliseconds(100);
  plan(pages(0, 1000), link);
  EXPECT_EQ(requests_.bytes_in_flight(), 1'120'000u);
  EXPECT_EQ(bytes_in_flight_max(link, 0.1), 1'125'000u);
}

TEST_F(PageRequestsAt, ACoarserPageGoesBeforeAFinerOneOfTheSameUrgency) {
  const auto& asked =
      plan({{PageItem::of_page(1), kPartBytes, 5}, {PageItem::of_page(9), kPartBytes, 5}}).ask;
  EXPECT_EQ(asked.front(), PageItem::of_page(9));
}

TEST_F(PageRequestsAt, ABlockGoesBeforeAPageOfTheSameUrgency) {
  const auto& asked =
      plan({{PageItem::of_page(1), kPartBytes, 5}, {PageItem::of_block(0), kPartBytes, 5}}).ask;
  EXPECT_EQ(asked.front(), PageItem::of_block(0));
}

TEST_F(PageRequestsAt, WhatIsInFlightIsNotAskedForAgain) {
  plan(pages(0, 4));
  EXPECT_TRUE(plan(pages(0, 4)).ask.empty());
  requests_.on_arrival(PageItem::of_page(2));
  EXPECT_EQ(plan(pages(2, 3)).ask.size(), 1u);
}

TEST_F(PageRequestsAt, AnItemLargerThanTheLimitGoesAlone) {
  const MissingItem large = {PageItem::of_page(1), 200'000, 9};
  EXPECT_EQ(plan({large, {PageItem::of_page(0), kPartBytes, 1}}).ask.size(), 1u);
  EXPECT_TRUE(plan({{PageItem::of_page(0), kPartBytes, 1}}).ask.empty());
  requests_.on_arrival(PageItem::of_page(1));
  EXPECT_EQ(plan({{PageItem::of_page(0), kPartBytes, 1}}).ask.size(), 1u);
}

TEST_F(PageRequestsAt, StaleItemsAreCancelledWhenOthersWait) {
  plan(pages(0, 6));
  const auto is_wanted = [](PageItem item) { return item.number >= 3; };
  EXPECT_TRUE(plan({}, kUnknownLink, is_wanted).cancel.empty()) << "the link has nothing better";
  const auto& next = plan(pages(10, 12), kUnknownLink, is_wanted);
  EXPECT_EQ(next.ask.size(), 2u);
  EXPECT_EQ(next.cancel.size(), 2u);
  for (const PageItem item : next.cancel) EXPECT_LT(item.number, 3u);
}

TEST_F(PageRequestsAt, AFailedItemWaitsAndIsAskedForAgain) {
  plan(pages(0, 1));
  requests_.on_failure(PageItem::of_page(0), unavailable("gone"), now_);
  EXPECT_TRUE(plan(pages(0, 1)).ask.empty());
  now_ += PageFailures::kFirstPause;
  EXPECT_EQ(plan(pages(0, 1)).ask.size(), 1u);
}

TEST_F(PageRequestsAt, AnItemThatNeverComesIsCancelledAndAskedForAgain) {
  plan(pages(0, 1));
  now_ += std::chrono::seconds(5);
  EXPECT_EQ(plan(pages(0, 1)).cancel.size(), 1u);
  now_ += PageFailures::kFirstPause;
  EXPECT_EQ(plan(pages(0, 1)).ask.size(), 1u);
}

TEST_F(PageRequestsAt, ABrokenLinkIsNoItemsFault) {
  plan(pages(0, 4));
  requests_.on_link_lost();
  EXPECT_EQ(requests_.bytes_in_flight(), 0u);
  EXPECT_EQ(plan(pages(0, 4)).ask.size(), 4u);
}

}  // namespace
}  // namespace burnish
