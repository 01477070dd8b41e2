#include "client/sheets/sheet_loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/pages/synthetic_scan.h"

namespace burnish {
namespace {

using testing::Contains;
using testing::Each;
using testing::IsEmpty;
using testing::Not;

constexpr uint32_t kChartBytes = 40;
constexpr uint16_t kSide = 64;

/// Sheets of a synthetic scan: three for each page, the finest with `texels` along a mean edge.
struct MadeDirectory {
  explicit MadeDirectory(const PageDirectory& pages, float texels = 8) {
    for (uint32_t b = 0; b < pages.head.blocks.size(); ++b) {
      const PageRange range = pages.head.pages_of(b);
      SheetBlock block{range.begin, {}, {}};
      for (PageId page = range.begin; page < range.end; ++page) {
        block.charts.push_back({kChartBytes, texels / pages.entries[page].bounds.edge});
        const SheetEntry sheets[] = {
            {900, kSide, kSide}, {300, kSide / 2, kSide / 2}, {100, kSide / 4, kSide / 4}};
        block.sheets.add(sheets);
      }
      blocks.push_back(encode_sheet_block(block));
      head.blocks.push_back({1300ULL * range.begin, 0, static_cast<uint32_t>(blocks[b].size())});
      head.sheet_bytes += 1300ULL * range.count();
      head.chart_bytes += uint64_t{kChartBytes} * range.count();
      head.block_bytes += blocks[b].size();
    }
    for (uint32_t b = 0; b < head.blocks.size(); ++b)
      head.blocks[b].chart_begin =
          head.sheet_bytes + uint64_t{kChartBytes} * pages.head.pages_of(b).begin;
  }

  SheetHead head;
  std::vector<std::vector<uint8_t>> blocks;
};

std::shared_ptr<const PageTexture> texture_of(uint8_t halving) {
  auto made = std::make_shared<PageTexture>();
  const int side = kSide >> halving;
  made->levels = texture_levels(side, side, std::vector<Rgba8>(size_t(side) * side));
  return made;
}

class LoadedSheets : public testing::Test {
 protected:
  explicit LoadedSheets(uint64_t budget = 10'000'000)
      : pages_(scan_.directory.head), loader_(made_.head, scan_.directory.head, budget) {
    for (uint32_t b = 0; b < scan_.directory.head.blocks.size(); ++b) pages_.add(b, scan_.block(b));
    for (PageId page = 0; page < 40; ++page) drawn_.push_back(page);
    look_from(1.9);
  }

  void look_from(double distance) {
    question_.view =
        make_page_view(camera_over(0.5, 0.5, distance), kFlightPicture, scan_.directory.head.grid);
  }

  void look() {
    question_.drawn = drawn_;
    now_ += std::chrono::milliseconds(20);
    loader_.look(question_, pages_, now_);
    asked_.insert(asked_.end(), loader_.requests().ask.begin(), loader_.requests().ask.end());
  }

  /// Brings and decodes what was asked for.
  void deliver() {
    for (const PageItem item : std::exchange(asked_, {})) {
      come_.push_back(item);
      std::vector<uint8_t> bytes(item.kind == PageItem::Kind::kCharts ? kChartBytes : 100);
      if (item.kind == PageItem::Kind::kSheetBlock) bytes = made_.blocks[item.number];
      loader_.on_arrival(item, std::move(bytes), now_);
    }
    look();
    const auto page = std::make_shared<const Page>();
    for (const EncodedTexture& job : loader_.take_jobs([&](PageId) { return page; }))
      loader_.on_decoded({job.sheet, texture_of(job.sheet.halving), Status::ok(), {}}, now_);
  }

  /// Looks until nothing more is asked for.
  void settle() {
    look();
    for (int i = 0; i < 100 && !(loader_.is_settled() && asked_.empty()); ++i) {
      deliver();
      look();
    }
  }

  SyntheticScan scan_ = make_synthetic_scan({.side = 16});
  MadeDirectory made_{scan_.directory};
  KnownPages pages_;
  SheetLoader loader_;
  std::vector<PageId> drawn_;
  SheetQuestion question_;
  PageRequests::Time now_{};
  std::vector<PageItem> asked_;
  std::vector<PageItem> come_;
};

TEST_F(LoadedSheets, EveryDrawnPageGetsATexture) {
  question_.is_at_rest = true;
  settle();
  ASSERT_TRUE(loader_.is_settled());
  EXPECT_TRUE(loader_.has_all());
  for (const PageId page : drawn_) EXPECT_NE(loader_.texture(page), nullptr) << page;
  EXPECT_EQ(loader_.texture(60), nullptr);
}

TEST_F(LoadedSheets, ThePromptSheetsComeBeforeThoseOfAPictureAtRest) {
  question_.is_at_rest = true;
  settle();
  std::vector<uint8_t> halvings;
  for (const PageItem item : come_)
    if (item.kind == PageItem::Kind::kSheet && item.number == 0) halvings.push_back(item.halving);
  EXPECT_TRUE(std::ranges::is_sorted(halvings, std::greater<>()));
  question_.is_at_rest = false;
  come_.clear();
  look();
  deliver();
  EXPECT_THAT(come_, IsEmpty()) << "finer sheets stay";
}

TEST_F(LoadedSheets, NothingIsAskedForWhilePagesWaitForTheLink) {
  question_.may_ask = false;
  look();
  EXPECT_THAT(asked_, IsEmpty());
  EXPECT_FALSE(loader_.is_settled());
}

TEST_F(LoadedSheets, APictureWithoutPagesAsksForNothing) {
  drawn_.clear();
  look();
  EXPECT_THAT(asked_, IsEmpty());
}

TEST_F(LoadedSheets, ADamagedSheetIsAskedForOnceMoreAndThenLeft) {
  drawn_ = {3};
  int tries = 0;
  for (int i = 0; i < 20; ++i) {
    now_ += std::chrono::seconds(2);
    look();
    for (const PageItem item : std::exchange(asked_, {})) {
      tries += item.kind == PageItem::Kind::kSheet;
      std::vector<uint8_t> bytes(kChartBytes);
      if (item.kind == PageItem::Kind::kSheetBlock) bytes = made_.blocks[item.number];
      loader_.on_arrival(item, std::move(bytes), now_);
    }
    look();
    const auto page = std::make_shared<const Page>();
    for (const EncodedTexture& job : loader_.take_jobs([&](PageId) { return page; }))
      loader_.on_decoded({job.sheet, nullptr, data_loss("bad checksum"), job.sheet}, now_);
  }
  EXPECT_EQ(tries, 2);
  EXPECT_EQ(loader_.texture(3), nullptr);
  EXPECT_EQ(loader_.take_given_up().size(), 1u);
  question_.is_at_rest = true;
  look();
  look();
  EXPECT_TRUE(loader_.is_settled());
  EXPECT_FALSE(loader_.has_all());
}

TEST_F(LoadedSheets, WhatNoPictureDrewIsNotKept) {
  look();
  loader_.on_arrival(PageItem::of_sheet(200, 0), std::vector<uint8_t>(1000), now_);
  EXPECT_EQ(loader_.store().find(200), nullptr);
}

class FewSheets : public LoadedSheets {
 protected:
  static constexpr uint64_t kBudget = 40 * 14'000;
  FewSheets() : LoadedSheets(kBudget) {}
};

TEST_F(FewSheets, AllAreCoarserWhereTheBudgetIsSmall) {
  look_from(0.02);
  question_.is_at_rest = true;
  settle();
  ASSERT_TRUE(loader_.is_settled());
  EXPECT_FALSE(loader_.has_all());
  for (const PageId page : drawn_) ASSERT_NE(loader_.texture(page), nullptr) << page;
  EXPECT_LE(loader_.store().bytes(), kBudget);
}

TEST_F(FewSheets, AFlightStaysInsideTheBudget) {
  for (PageId first = 0; first + 40 < scan_.directory.head.page_count(); first += 10) {
    drawn_.clear();
    for (PageId page = first; page < first + 40; ++page) drawn_.push_back(page);
    look_from(first % 20 == 0 ? 0.05 : 1.9);
    settle();
    EXPECT_LE(loader_.store().bytes(), kBudget);
  }
}

}  // namespace
}  // namespace burnish
