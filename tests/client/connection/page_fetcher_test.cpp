#include "client/connection/page_fetcher.h"

#include <atomic>
#include <chrono>
#include <map>
#include <optional>
#include <span>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/service/scan_pages.h"
#include "tests/client/connection/fake_library.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Le;
using testing::Not;
using testing::SizeIs;

std::vector<PageItem> page_items(uint32_t begin, uint32_t end) {
  std::vector<PageItem> items;
  for (uint32_t page = begin; page < end; ++page) items.push_back(PageItem::of_page(page));
  return items;
}

/// A fake server, a fetcher over it, and what has come.
class FetchedPages : public testing::Test {
 protected:
  FetchedPages() { connect(); }

  void connect(std::shared_ptr<PageDisk> disk = nullptr) {
    fetcher_ = std::make_unique<PageFetcher>(
        connection_, "scan", [this] { ++news_; }, std::move(disk));
  }

  /// Takes what comes until `what` holds. Returns false after the patience.
  template <typename What>
  bool until(What what) {
    for (int i = 0; i < 10'000; ++i) {
      for (PageFetcher::Arrival& arrival : fetcher_->take()) {
        order_.push_back(arrival.item);
        EXPECT_TRUE(come_.emplace(arrival.item, std::move(arrival.bytes)).second) << "came twice";
      }
      if (what()) return true;
      std::this_thread::sleep_for(milliseconds(1));
    }
    return false;
  }
  bool until_come(size_t items) {
    return until([&] { return come_.size() >= items; });
  }
  bool until_called(size_t calls) {
    return until([&] { return server_.seen().calls.size() >= calls; });
  }
  void expect_good(PageItem item) {
    ASSERT_TRUE(come_.contains(item)) << item.number;
    const auto& bytes = come_.at(item);
    ASSERT_TRUE(bytes.is_ok()) << bytes.status().message();
    EXPECT_EQ(*bytes, FakeLibrary::bytes_of(item));
  }
  StatusCode code_of(PageItem item) const { return come_.at(item).status().code(); }
  void forget() { come_.clear(), order_.clear(); }

  FakeLibrary server_;
  Connection connection_ = Connection::open(server_.address(), milliseconds(10'000)).value();
  std::atomic<int> news_{0};
  std::unique_ptr<PageFetcher> fetcher_;
  std::map<PageItem, Result<std::vector<uint8_t>>> come_;
  std::vector<PageItem> order_;
};

TEST_F(FetchedPages, ComeInTheOrderAsked) {
  const std::vector<PageItem> items = {PageItem::of_block(3), PageItem::of_page(9),
                                       PageItem::of_page(2), PageItem::of_page(5)};
  fetcher_->ask(items);
  ASSERT_TRUE(until_come(4));
  EXPECT_EQ(order_, items);
  for (const PageItem item : items) expect_good(item);
  EXPECT_GT(news_, 0);
  EXPECT_EQ(server_.seen().scan, "scan");
}

TEST_F(FetchedPages, SheetsComeAfterPagesByACallOfTheirOwn) {
  server_.set_faults({.holds = true});
  fetcher_->ask(page_items(0, 300));
  ASSERT_TRUE(until_called(2));
  const std::vector<PageItem> sheets = {PageItem::of_sheet_block(1), PageItem::of_charts(4),
                                        PageItem::of_sheet(4, 2), PageItem::of_sheet(4, 0)};
  fetcher_->ask(sheets);
  server_.set_faults({});
  ASSERT_TRUE(until_come(304));
  for (const PageItem item : sheets) expect_good(item);
  // Two calls are under way at once, so the server may see the last two in either order.
  const std::vector<std::vector<PageItem>> calls = server_.seen().calls;
  ASSERT_GT(calls.size(), 2u);
  EXPECT_THAT(std::span(calls).last(2), Contains(sheets));
  EXPECT_THAT(std::span(calls).first(calls.size() - 2), Not(Contains(sheets)));
}

TEST_F(FetchedPages, SheetsThatTheServerLeavesOutFail) {
  server_.set_faults({.left_out = {4}});
  const std::vector<PageItem> sheets = {PageItem::of_charts(3), PageItem::of_sheet(4, 2)};
  fetcher_->ask(sheets);
  ASSERT_TRUE(until_come(2));
  expect_good(sheets[0]);
  EXPECT_EQ(code_of(sheets[1]), StatusCode::kDataLoss);
}

TEST_F(FetchedPages, AreAskedForByTwoCallsAtMostAndFewAtOnce) {
  server_.set_faults({.holds = true});
  fetcher_->ask(page_items(0, 300));
  ASSERT_TRUE(until_called(2));
  EXPECT_TRUE(come_.empty());
  server_.set_faults({});
  ASSERT_TRUE(until_come(300));
  EXPECT_EQ(server_.seen().calls_at_once_max, 2u);
  EXPECT_THAT(server_.seen().calls, Each(SizeIs(Le(kPagePartsPerFetchMax))));
  size_t asked = 0;
  for (const auto& call : server_.seen().calls) asked += call.size();
  EXPECT_EQ(asked, 300u);
  for (const PageItem item : page_items(0, 300)) expect_good(item);
}

TEST_F(FetchedPages, AreFetchedOnceHoweverOftenTheyAreAskedFor) {
  server_.set_faults({.holds = true});
  for (int i = 0; i < 5; ++i) fetcher_->ask(page_items(0, 3));
  ASSERT_TRUE(until_called(1));
  fetcher_->ask(page_items(0, 3));
  server_.set_faults({});
  ASSERT_TRUE(until_come(3));
  EXPECT_THAT(server_.seen().calls, ElementsAre(SizeIs(3)));
  forget();
  fetcher_->ask(page_items(0, 3));
  EXPECT_TRUE(until_come(3));
}

TEST_F(FetchedPages, DoNotComeOnceTheyAreCancelled) {
  server_.set_faults({.holds = true});
  fetcher_->ask(page_items(0, 200));
  ASSERT_TRUE(until_called(2));
  fetcher_->cancel(page_items(1, 199));  // some under way, some that wait
  server_.set_faults({});
  ASSERT_TRUE(until_come(2));
  EXPECT_EQ(order_.size(), 2u);
  expect_good(PageItem::of_page(0));
  expect_good(PageItem::of_page(199));
  for (const auto& call : server_.seen().calls)
    for (const PageItem item : call)
      EXPECT_TRUE(item.number < 128 || item.number == 199) << item.number;
}

TEST_F(FetchedPages, MakeRoomForOthersWhenAllOfACallAreCancelled) {
  server_.set_faults({.holds = true});
  fetcher_->ask(page_items(0, 100));
  ASSERT_TRUE(until_called(2));
  fetcher_->cancel(page_items(0, 100));
  fetcher_->ask(page_items(200, 201));
  ASSERT_TRUE(until([this] { return server_.seen().cancelled == 2; }));
  server_.set_faults({});
  ASSERT_TRUE(until_come(1));
  expect_good(PageItem::of_page(200));
}

TEST_F(FetchedPages, ComeWhenTheyAreAskedForAgainAfterTheirCallWasCancelled) {
  server_.set_faults({.holds = true});
  fetcher_->ask(page_items(0, 2));
  ASSERT_TRUE(until_called(1));
  fetcher_->cancel(page_items(0, 2));
  fetcher_->ask(page_items(0, 2));
  server_.set_faults({});
  ASSERT_TRUE(until_come(2));
  expect_good(PageItem::of_page(0));
  expect_good(PageItem::of_page(1));
}

TEST_F(FetchedPages, TellWhyTheirCallFailed) {
  server_.set_faults({.parts_max = 1, .ends_with = grpc::StatusCode::DATA_LOSS});
  fetcher_->ask(page_items(0, 3));
  ASSERT_TRUE(until_come(3));
  expect_good(PageItem::of_page(0));
  EXPECT_EQ(code_of(PageItem::of_page(1)), StatusCode::kDataLoss);
  EXPECT_THAT(come_.at(PageItem::of_page(2)).status().message(), HasSubstr("not today"));
  forget();
  server_.set_faults({});
  fetcher_->ask(page_items(1, 3));
  ASSERT_TRUE(until_come(2));
  expect_good(PageItem::of_page(2));
}

TEST_F(FetchedPages, FailWhenTheServerLeavesThemOut) {
  server_.set_faults({.left_out = {1}});
  fetcher_->ask(page_items(0, 3));
  ASSERT_TRUE(until_come(3));
  expect_good(PageItem::of_page(2));
  EXPECT_EQ(code_of(PageItem::of_page(1)), StatusCode::kDataLoss);
  EXPECT_THAT(come_.at(PageItem::of_page(1)).status().message(), HasSubstr("page 1"));
}

TEST_F(FetchedPages, AllFailWhenTheLinkIsLostAndComeFromTheNextServer) {
  server_.set_faults({.holds = true});
  fetcher_->ask(page_items(0, 300));
  ASSERT_TRUE(until_called(2));
  server_.stop();
  ASSERT_TRUE(until_come(300));
  for (const PageItem item : page_items(0, 300))
    EXPECT_EQ(code_of(item), StatusCode::kUnavailable) << item.number;
  forget();
  fetcher_->ask(page_items(0, 1));
  ASSERT_TRUE(until_come(1));
  EXPECT_EQ(code_of(PageItem::of_page(0)), StatusCode::kUnavailable);
  forget();
  server_.set_faults({});
  server_.start();
  fetcher_->ask(page_items(0, 300));
  ASSERT_TRUE(until_come(300));
  for (const PageItem item : page_items(0, 300)) expect_good(item);
}

TEST_F(FetchedPages, MayComeInAnotherOrder) {
  server_.set_faults({.turns_around = true});
  fetcher_->ask(page_items(0, 10));
  ASSERT_TRUE(until_come(10));
  EXPECT_EQ(order_.front(), PageItem::of_page(9));
  for (const PageItem item : page_items(0, 10)) expect_good(item);
}

TEST_F(FetchedPages, ComeFromTheDiskWhereItHasThem) {
  const TemporaryFolder folder;
  const auto disk = std::make_shared<PageDisk>(folder / "pages", 1);
  disk->keep(PageItem::of_page(1), FakeLibrary::bytes_of(PageItem::of_page(1)));
  connect(disk);
  fetcher_->ask(page_items(0, 3));
  ASSERT_TRUE(until_come(3));
  for (const PageItem item : page_items(0, 3)) expect_good(item);
  EXPECT_THAT(server_.seen().calls,
              ElementsAre(ElementsAre(PageItem::of_page(0), PageItem::of_page(2))));
  EXPECT_TRUE(disk->find(PageItem::of_page(2)).is_ok());
  server_.stop();
  forget();
  fetcher_->ask(page_items(0, 3));
  ASSERT_TRUE(until_come(3));
  for (const PageItem item : page_items(0, 3)) expect_good(item);
}

TEST_F(FetchedPages, MeasureTheTimeToTheFirstPart) {
  EXPECT_EQ(fetcher_->speed().round_trip_seconds, 0);
  fetcher_->ask(page_items(0, 1));
  ASSERT_TRUE(until_come(1));
  EXPECT_GT(fetcher_->speed().round_trip_seconds, 0);
}

TEST_F(FetchedPages, CanBeLeftAtAnyMoment) {
  for (int i = 0; i < 30; ++i) {
    connect();
    server_.set_faults({.holds = i % 3 == 0});
    fetcher_->ask(page_items(0, 100));
    std::this_thread::sleep_for(milliseconds(i % 6));  // waits for nothing: picks the moment
  }
  const auto begin = std::chrono::steady_clock::now();
  fetcher_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, milliseconds(20'000));  // of a stuck call
}

}  // namespace
}  // namespace burnish
