#include "client/pages/page_delivery.h"

#include <chrono>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<uint8_t> bytes_of(size_t count) {
  return std::vector<uint8_t>(count, 7);
}

class Deliveries : public testing::Test {
 protected:
  void ask(const std::vector<PageItem>& items) { delivery_.ask(items); }
  std::optional<PageDelivery::Call> begin() {
    return delivery_.begin(delivery_.next_batch(), now_);
  }
  bool bring(PageDelivery::Call call, PageItem item) {
    now_ += milliseconds(10);
    return delivery_.on_part(call, item, bytes_of(1000), now_);
  }

  PageDelivery delivery_{"scanner:7411"};
  PageDelivery::Time now_{milliseconds(1000)};
};

TEST_F(Deliveries, BringEachItemOnceInTheOrderOfTheCall) {
  ask({PageItem::of_page(3), PageItem::of_page(1)});
  const auto batch = delivery_.next_batch();
  EXPECT_THAT(batch, ElementsAre(PageItem::of_page(3), PageItem::of_page(1)));
  const auto call = delivery_.begin(batch, now_);
  ASSERT_TRUE(call);
  EXPECT_TRUE(bring(*call, PageItem::of_page(3)));
  EXPECT_TRUE(bring(*call, PageItem::of_page(1)));
  EXPECT_FALSE(delivery_.end(*call, Status::ok()));
  const auto arrived = delivery_.take();
  ASSERT_THAT(arrived, SizeIs(2));
  EXPECT_EQ(arrived[0].item, PageItem::of_page(3));
  EXPECT_EQ(arrived[1].item, PageItem::of_page(1));
  EXPECT_THAT(delivery_.take(), IsEmpty());
}

TEST_F(Deliveries, AnItemThatTheServerLeftOutFailsByItsName) {
  ask({PageItem::of_page(1), PageItem::of_page(2)});
  const auto call = begin();
  bring(*call, PageItem::of_page(1));
  EXPECT_TRUE(delivery_.end(*call, Status::ok()));
  const auto arrived = delivery_.take();
  ASSERT_THAT(arrived, SizeIs(2));
  EXPECT_EQ(arrived[1].bytes.status().code(), StatusCode::kDataLoss);
  EXPECT_THAT(arrived[1].bytes.status().message(), HasSubstr("scanner:7411 left out page 2"));
}

TEST_F(Deliveries, ACallWhoseItemsNobodyWantsIsCancelledOnce) {
  ask({PageItem::of_page(1), PageItem::of_page(2)});
  const auto call = begin();
  EXPECT_THAT(delivery_.cancel(std::vector{PageItem::of_page(1)}), IsEmpty());
  EXPECT_THAT(delivery_.cancel(std::vector{PageItem::of_page(2)}), ElementsAre(*call));
  EXPECT_THAT(delivery_.cancel(std::vector{PageItem::of_page(2)}), IsEmpty());
}

TEST_F(Deliveries, APartThatMakesTheCallUselessEndsIt) {
  ask({PageItem::of_page(1), PageItem::of_page(2)});
  const auto call = begin();
  delivery_.cancel(std::vector{PageItem::of_page(2)});
  EXPECT_FALSE(bring(*call, PageItem::of_page(1)));
}

TEST_F(Deliveries, AnItemAskedForAgainAfterItsCallWasCancelledWaitsForAnother) {
  ask({PageItem::of_page(1)});
  const auto call = begin();
  delivery_.cancel(std::vector{PageItem::of_page(1)});
  ask({PageItem::of_page(1)});
  EXPECT_TRUE(delivery_.end(*call, {StatusCode::kCancelled, "cancelled"}));
  EXPECT_THAT(delivery_.take(), IsEmpty());
  EXPECT_THAT(delivery_.next_batch(), ElementsAre(PageItem::of_page(1)));
}

TEST_F(Deliveries, ABatchThatNobodyWantsAnyMoreMakesNoCall) {
  ask({PageItem::of_page(1)});
  const auto batch = delivery_.next_batch();
  delivery_.cancel(batch);
  EXPECT_FALSE(delivery_.begin(batch, now_));
}

TEST_F(Deliveries, ALostConnectionFailsWhatWaitsToo) {
  ask({PageItem::of_page(1)});
  const auto call = begin();
  ask({PageItem::of_page(2)});
  delivery_.end(*call, unavailable("gone"));
  const auto arrived = delivery_.take();
  ASSERT_THAT(arrived, SizeIs(2));
  for (const PageSource::Arrival& each : arrived)
    EXPECT_EQ(each.bytes.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(delivery_.next_batch(), IsEmpty());
}

TEST_F(Deliveries, AnItemFoundElsewhereNeedsNoCall) {
  ask({PageItem::of_page(1)});
  delivery_.next_batch();
  EXPECT_TRUE(delivery_.on_found(PageItem::of_page(1), bytes_of(10)));
  EXPECT_FALSE(delivery_.on_found(PageItem::of_page(1), bytes_of(10)));
  EXPECT_THAT(delivery_.take(), SizeIs(1));
}

TEST_F(Deliveries, TheSpeedIsThatOfTheParts) {
  std::vector<PageItem> items;
  for (uint32_t i = 0; i < 60; ++i) items.push_back(PageItem::of_page(i));
  ask(items);
  const auto batch = delivery_.next_batch();
  const auto call = delivery_.begin(batch, now_);
  for (const PageItem item : batch) {
    now_ += milliseconds(10);
    delivery_.on_part(*call, item, bytes_of(10'000), now_);
  }
  EXPECT_NEAR(delivery_.speed().bytes_per_second, 1e6, 1e4);
  EXPECT_NEAR(delivery_.speed().round_trip_seconds, 0.01, 1e-6);
}

}  // namespace
}  // namespace burnish
