#include "client/pages/fetch_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/service/scan_pages.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

PageItem page(PageId id) {
  return PageItem::of_page(id);
}

void ask(FetchQueue& queue, PageId begin, PageId end) {
  for (PageId id = begin; id < end; ++id) queue.ask(page(id));
}

TEST(FetchQueue, HandsOutItemsInTheOrderAsked) {
  FetchQueue queue;
  queue.ask(page(7));
  queue.ask(PageItem::of_block(1));
  queue.ask(page(7));
  queue.ask(page(3));
  EXPECT_THAT(queue.take_batch(), ElementsAre(page(7), PageItem::of_block(1), page(3)));
  EXPECT_THAT(queue.take_batch(), IsEmpty());
}

TEST(FetchQueue, SheetsComeAfterAllPagesAndInCallsOfTheirOwn) {
  FetchQueue queue;
  const PageItem charts = PageItem::of_charts(7), sheet = PageItem::of_sheet(7, 2);
  queue.ask(sheet);
  queue.ask(charts);
  queue.ask(page(3));
  EXPECT_THAT(queue.take_batch(), ElementsAre(page(3)));
  EXPECT_THAT(queue.take_batch(), ElementsAre(sheet, charts));
  queue.ask(PageItem::of_sheet(7, 1));
  EXPECT_THAT(queue.give_up_waiting(), ElementsAre(PageItem::of_sheet(7, 1)));
}

TEST(FetchQueue, SheetsOfOneVersionComeInACall) {
  FetchQueue queue;
  const PageItem own = PageItem::of_charts(7), other = PageItem::of_charts(7, 9);
  const PageItem sheet = PageItem::of_sheet(7, 2, 9);
  for (const PageItem item : {own, other, sheet}) queue.ask(item);
  EXPECT_THAT(queue.take_batch(), ElementsAre(own));
  EXPECT_THAT(queue.take_batch(), ElementsAre(other, sheet));
}

TEST(FetchQueue, TakesFewItemsAtOnceWhereTheyAreLarge) {
  FetchQueue queue;
  ask(queue, 0, 1000);
  const auto first = queue.take_batch();
  EXPECT_LE(first.size() * 10'000, kFetchBytesMax);
  for (const PageItem item : first) EXPECT_TRUE(queue.arrive(item, 50'000));
  EXPECT_THAT(queue.take_batch(), SizeIs(kFetchBytesMax / 50'000));
}

TEST(FetchQueue, TakesAsManySmallItemsAsACallMayHave) {
  FetchQueue queue;
  ask(queue, 0, 1000);
  for (const PageItem item : queue.take_batch()) queue.arrive(item, 10);
  EXPECT_THAT(queue.take_batch(), SizeIs(kPagePartsPerFetchMax));
}

TEST(FetchQueue, TakesAnItemAloneThatIsLargerThanTheLimit) {
  FetchQueue queue;
  ask(queue, 0, 100);
  for (const PageItem item : queue.take_batch()) queue.arrive(item, 2 * kFetchBytesMax);
  EXPECT_THAT(queue.take_batch(), SizeIs(1));
}

TEST(FetchQueue, LeavesOutWhatWasCancelled) {
  FetchQueue queue;
  ask(queue, 0, 4);
  queue.cancel(page(1));
  queue.cancel(page(2));
  queue.ask(page(2));
  const auto batch = queue.take_batch();
  EXPECT_THAT(batch, ElementsAre(page(0), page(2), page(3)));
  queue.cancel(page(3));
  EXPECT_FALSE(queue.arrive(page(3), 10));
  EXPECT_TRUE(queue.arrive(page(0), 10));
  EXPECT_THAT(queue.end(batch), ElementsAre(page(2)));
}

TEST(FetchQueue, DoesNotTakeAgainWhatIsUnderWay) {
  FetchQueue queue;
  ask(queue, 0, 1);
  EXPECT_THAT(queue.take_batch(), SizeIs(1));
  queue.cancel(page(0));
  queue.ask(page(0));
  EXPECT_THAT(queue.take_batch(), IsEmpty());
  EXPECT_TRUE(queue.arrive(page(0), 10));
}

TEST(FetchQueue, GivesUpWhatWaitsAndKeepsWhatIsUnderWay) {
  FetchQueue queue;
  ask(queue, 0, 40);
  const auto batch = queue.take_batch();
  const size_t waiting = 40 - batch.size();
  queue.cancel(page(39));
  EXPECT_THAT(queue.give_up_waiting(), SizeIs(waiting - 1));
  EXPECT_THAT(queue.take_batch(), IsEmpty());
  EXPECT_TRUE(queue.arrive(batch[0], 10));
  queue.ask(page(39));
  EXPECT_THAT(queue.take_batch(), ElementsAre(page(39)));
}

}  // namespace
}  // namespace burnish
