#include "client/pages/page_failures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;

constexpr PageItem kItem = PageItem::of_page(7);

TEST(PageFailures, EachPauseIsTwiceTheLast) {
  PageFailures failures;
  PageFailures::Time now = {};
  EXPECT_TRUE(failures.may_ask(kItem, now));
  for (const int pause_ms : {500, 1000, 2000, 4000}) {
    failures.on_failure(kItem, unavailable("gone"), now);
    EXPECT_FALSE(failures.may_ask(kItem, now + milliseconds(pause_ms - 1)));
    now += milliseconds(pause_ms);
    EXPECT_TRUE(failures.may_ask(kItem, now));
  }
}

TEST(PageFailures, TheFifthFailureGivesUpAndIsToldOnce) {
  PageFailures failures;
  for (int i = 0; i < 9; ++i) failures.on_failure(kItem, data_loss("bad checksum"), {});
  EXPECT_TRUE(failures.is_given_up(kItem));
  EXPECT_FALSE(failures.may_ask(kItem, PageFailures::Time::max()));
  const auto news = failures.take_news();
  ASSERT_EQ(news.size(), 1u);
  EXPECT_EQ(news[0].item, kItem);
  EXPECT_THAT(news[0].last_failure.message(), testing::HasSubstr("bad checksum"));
  EXPECT_TRUE(failures.take_news().empty());
}

TEST(PageFailures, ASuccessForgetsThePastOfItsItem) {
  PageFailures failures;
  for (int i = 0; i < 4; ++i) failures.on_failure(kItem, unavailable("gone"), {});
  failures.on_success(kItem);
  EXPECT_TRUE(failures.may_ask(kItem, {}));
  EXPECT_EQ(failures.count(), 0u);
}

TEST(PageFailures, BlocksAndPagesOfOneNumberAreTwoItems) {
  PageFailures failures;
  failures.on_failure(PageItem::of_page(3), unavailable("gone"), {});
  EXPECT_TRUE(failures.may_ask(PageItem::of_block(3), {}));
}

TEST(PageFailures, ASheetIsTriedTwice) {
  PageFailures failures;
  const PageItem sheet = PageItem::of_sheet(7, 1);
  failures.on_failure(sheet, data_loss("bad checksum"), {});
  EXPECT_FALSE(failures.is_given_up(sheet));
  failures.on_failure(sheet, data_loss("bad checksum"), {});
  EXPECT_TRUE(failures.is_given_up(sheet));
  EXPECT_FALSE(failures.is_given_up(PageItem::of_sheet(7, 0)));
}

}  // namespace
}  // namespace burnish
