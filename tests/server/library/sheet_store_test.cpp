#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <future>
#include <optional>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/pages/directory_codec.h"
#include "common/sheets/sheet_codec.h"
#include "common/sheets/sheet_directory.h"
#include "server/library/levelled_sheets.h"
#include "server/library/scan_record.h"
#include "server/library/stale_files.h"
#include "tests/server/manager/test_library.h"
#include "tests/server/prepare/sheets/photo_archive.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

std::string archive_of(const PaintedBall& ball) {
  const std::vector<uint8_t> zip = ball.zip();
  return {zip.begin(), zip.end()};
}

/// A library with a painted ball of 4,800 triangles: several pages.
class SheetStore : public testing::Test {
 protected:
  SheetStore() {
    const std::string zip = archive_of({.quads_per_side = 20, .face_texels = 100});
    scan_ = library_.import(zip, "ball", {}, 5, MeshFormat::kZip).value().scan;
  }

  fs::path path() const { return library_.folder->scans() / scan_.id / sheets_file_name(); }
  fs::path pages_path() const {
    return library_.folder->scans() / scan_.id / pages_file_name(true);
  }

  PageHead pages() {
    return decode_head(library_.store->describe_pages(scan_.id, {}).value().head).value();
  }
  Result<SheetsDescription> describe(const Progress& progress = {}) {
    return library_.store->describe_sheets(scan_.id, progress);
  }
  bool has_sheets() {
    const auto description = describe();
    EXPECT_TRUE(description.is_ok()) << description.status().to_string();
    return description.is_ok() && description->has_sheets();
  }

  Status read(const SheetsWish& wish) {
    order_.clear();
    sheets_.clear();
    const auto block = [this](const PagePart& part) {
      order_ += "b" + std::to_string(part.number);
    };
    const auto charts = [this](const PagePart& part) {
      order_ += "c" + std::to_string(part.number);
    };
    const auto sheet = [this](const SheetPart& part) {
      order_ += "s" + std::to_string(part.number.page) + "/" + std::to_string(part.number.halving);
      sheets_.push_back(part);
    };
    return library_.store->read_sheets(scan_.id, wish, {block, charts, sheet}, {});
  }
  Status read_first() { return read({"", {}, {}, {{0, 0}}}); }

  TestLibrary library_;
  ScanInfo scan_;
  std::string order_;  // of the last read
  std::vector<SheetPart> sheets_;
};

TEST_F(SheetStore, TheFirstDescriptionMakesTheSheets) {
  EXPECT_FALSE(fs::exists(path()));
  EXPECT_EQ(read_first().code(), StatusCode::kFailedPrecondition);
  EXPECT_TRUE(has_sheets());
  EXPECT_TRUE(fs::exists(path()));
  ASSERT_TRUE(read_first().is_ok());
  EXPECT_TRUE(decode_sheet(sheets_.at(0).bytes).is_ok());
}

TEST_F(SheetStore, MissingPagesAreMadeBefore) {
  fs::remove(pages_path());
  library_.restart();
  EXPECT_TRUE(has_sheets());
  EXPECT_TRUE(fs::exists(pages_path()));
}

TEST_F(SheetStore, TheDescriptionEndsWithTheBlockOfTheRoot) {
  const SheetsDescription description = describe().value();
  const SheetHead head = decode_sheet_head(description.head, pages()).value();
  ASSERT_FALSE(description.blocks.empty());
  EXPECT_EQ(description.blocks.back().number, pages().block_count() - 1);
  for (const PagePart& block : description.blocks)
    EXPECT_TRUE(decode_sheet_block(block.bytes, head, pages(), block.number).is_ok());
}

TEST_F(SheetStore, PartsComeInTheOrderOfTheWish) {
  ASSERT_TRUE(has_sheets());
  ASSERT_TRUE(read({"", {1, 0}, {0, 1}, {{1, 1}, {0, 0}}}).is_ok());
  EXPECT_EQ(order_, "b1b0c0c1s1/1s0/0");
}

TEST_F(SheetStore, APartThatTheScanDoesNotHaveIsRefused) {
  ASSERT_TRUE(has_sheets());
  const uint32_t count = pages().page_count();
  const Status page = read({"", {}, {}, {{0, 0}, {count, 0}}});
  EXPECT_EQ(page.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(page.message(), HasSubstr("page " + std::to_string(count)));
  EXPECT_TRUE(order_.empty());
  EXPECT_THAT(read({"", {}, {count}, {}}).message(), HasSubstr(std::to_string(count)));
  EXPECT_THAT(read({"", {99}, {}, {}}).message(), HasSubstr("block 99"));
  EXPECT_THAT(read({"", {}, {}, {{0, 8}}}).message(), HasSubstr("page 0: 8"));
}

TEST_F(SheetStore, PagesOfALargePictureAreManyAndAreSoAgainWhenTheyAreMadeAgain) {
  const std::string zip = archive_of({.quads_per_side = 10, .face_texels = 800});
  scan_ = library_.import(zip, "sharp", {}, 5, MeshFormat::kZip).value().scan;
  const PageHead imported = pages();
  EXPECT_GE(imported.level_pages.front(), 6u * 800 * 800 / (512 * 512));
  fs::remove(pages_path());
  library_.restart();
  EXPECT_EQ(pages().level_pages, imported.level_pages);
  EXPECT_TRUE(has_sheets());
}

TEST_F(SheetStore, AScanWithoutPicturesHasNoneAndIsNotReadForThem) {
  const ScanInfo plain = library_.import(sphere_file(), "plain").value().scan;
  fs::resize_file(library_.folder->scans() / plain.id / "original.ply", 10);
  const auto description = library_.store->describe_sheets(plain.id, {});
  ASSERT_TRUE(description.is_ok()) << description.status().to_string();
  EXPECT_FALSE(description->has_sheets());
  EXPECT_EQ(library_.store->read_sheets(plain.id, {"", {}, {}, {{0, 0}}}, {}, {}).code(),
            StatusCode::kFailedPrecondition);
}

TEST_F(SheetStore, APictureThatNobodyCanReadIsNone) {
  const std::vector<uint8_t> zip = PaintedBall{.quads_per_side = 4}.zip("GIF89a");
  const ScanInfo scan =
      library_.import({zip.begin(), zip.end()}, "gif", {}, 5, MeshFormat::kZip).value().scan;
  for (int time = 0; time < 2; ++time) {
    const auto description = library_.store->describe_sheets(scan.id, {});
    ASSERT_TRUE(description.is_ok()) << description.status().to_string();
    EXPECT_FALSE(description->has_sheets());
  }
}

TEST_F(SheetStore, ADamagedSheetIsRefusedAndTheSheetsAreMadeAgain) {
  ASSERT_TRUE(has_sheets());
  std::fstream(path(), std::ios::in | std::ios::out | std::ios::binary).seekp(100).put('\x5a');
  EXPECT_EQ(read_first().code(), StatusCode::kDataLoss);
  EXPECT_EQ(read_first().code(), StatusCode::kFailedPrecondition);
  EXPECT_TRUE(has_sheets());
  EXPECT_TRUE(read_first().is_ok());
}

TEST_F(SheetStore, DamagedPagesAreRefusedAndMadeAgain) {
  std::fstream(pages_path(), std::ios::in | std::ios::out | std::ios::binary).seekp(60).put('\x5a');
  EXPECT_EQ(describe().status().code(), StatusCode::kDataLoss);
  EXPECT_TRUE(has_sheets());
}

TEST_F(SheetStore, ADamagedOriginalLeavesThePages) {
  fs::resize_file(library_.folder->scans() / scan_.id / "original.zip", 100);
  library_.restart();
  EXPECT_EQ(describe().status().code(), StatusCode::kDataLoss);
  EXPECT_TRUE(fs::exists(pages_path()));
}

TEST_F(SheetStore, AFileThatWasCutIsMadeAgain) {
  ASSERT_TRUE(has_sheets());
  fs::resize_file(path(), fs::file_size(path()) / 2);
  library_.restart();
  EXPECT_EQ(read_first().code(), StatusCode::kFailedPrecondition);
  EXPECT_TRUE(has_sheets());
  EXPECT_TRUE(read_first().is_ok());
}

TEST_F(SheetStore, SheetsOfOtherPagesAreMadeAgain) {
  ASSERT_TRUE(has_sheets());
  const std::string other_zip = archive_of({.quads_per_side = 21, .face_texels = 100});
  const ScanInfo other = library_.import(other_zip, "other", {}, 5, MeshFormat::kZip).value().scan;
  ASSERT_TRUE(library_.store->describe_sheets(other.id, {}).is_ok());
  fs::copy_file(library_.folder->scans() / other.id / sheets_file_name(), path(),
                fs::copy_options::overwrite_existing);
  library_.restart();
  EXPECT_EQ(read_first().code(), StatusCode::kFailedPrecondition);
  EXPECT_TRUE(has_sheets());
  EXPECT_TRUE(read_first().is_ok());
}

TEST_F(SheetStore, TwoWhoAskAtOnceShareOneMaking) {
  std::atomic<int> makings{0};
  const auto ask = [&] {
    std::string last;
    const Progress count = [&](std::string_view phase, double) {
      if (phase == "pictures" && last != phase) ++makings;
      last = phase;
      return true;
    };
    EXPECT_TRUE(describe(count)->has_sheets());
  };
  std::thread one(ask), two(ask);
  one.join();
  two.join();
  EXPECT_EQ(makings, 1);
}

TEST_F(SheetStore, MakingThemCanBeCancelled) {
  const Progress cancel = [](std::string_view phase, double) { return phase != "sheets"; };
  EXPECT_EQ(describe(cancel).status().code(), StatusCode::kCancelled);
  EXPECT_FALSE(fs::exists(path()));
  EXPECT_TRUE(has_sheets());
}

bool cancel_after_a_page(std::string_view phase, double fraction) {
  return phase != "sheets" || fraction <= 0;
}

TEST_F(SheetStore, ACancelledMakingGoesOnWhenItIsAskedForAgain) {
  ASSERT_TRUE(has_sheets());
  const std::string at_once = content_of(path());
  fs::remove(path());
  library_.restart();
  ASSERT_EQ(describe(cancel_after_a_page).status().code(), StatusCode::kCancelled);
  size_t decodings = 0;
  const Progress count = [&](std::string_view phase, double) {
    decodings += phase == "pictures";
    return true;
  };
  ASSERT_TRUE(describe(count).is_ok());
  EXPECT_EQ(decodings, 0u);
  EXPECT_TRUE(content_of(path()) == at_once);
}

TEST_F(SheetStore, WhatACancelledMakingHasMadeGoesWhenAnotherScanIsPrepared) {
  const uint64_t before = library_.store->memory().taken();
  ASSERT_EQ(describe(cancel_after_a_page).status().code(), StatusCode::kCancelled);
  EXPECT_GT(library_.store->memory().taken(), before);
  const auto leftover = [&] {
    return std::ranges::count_if(fs::directory_iterator(path().parent_path()),
                                 [](const auto& e) { return e.path().extension() == ".tmp"; });
  };
  EXPECT_EQ(leftover(), 1);
  ASSERT_TRUE(library_.import(sphere_file(), "other").is_ok());
  ASSERT_TRUE(library_.store->describe_pages(library_.store->find("other")->id, {}).is_ok());
  EXPECT_EQ(leftover(), 0);
}

TEST_F(SheetStore, MakingThemBeyondTheMemoryIsRefusedWithTheNumbers) {
  library_.restart({.memory_bytes_max = 8 << 20});
  const Status status = describe().status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("limits.memory_bytes_max is 8388608"));
}

TEST_F(SheetStore, NothingOfTheMakingStaysInMemory) {
  const uint64_t before = library_.store->memory().taken();
  ASSERT_TRUE(has_sheets());
  EXPECT_LT(library_.store->memory().taken(), before + (64 << 10));
}

TEST_F(SheetStore, PagesThatEndByAnOlderRuleAreMadeAgain) {
  const PageHead head = pages();
  const fs::path older = pages_path().parent_path() / pages_file_name();
  fs::rename(pages_path(), older);
  library_.restart();
  EXPECT_EQ(pages().level_pages, head.level_pages);
  EXPECT_TRUE(fs::exists(pages_path()));
  EXPECT_FALSE(fs::exists(older));
  EXPECT_TRUE(has_sheets());
}

TEST_F(SheetStore, AScanThatLostItsFileKeepsItsPages) {
  const PageHead head = pages();
  fs::remove(pages_path().parent_path() / original_file_name(MeshFormat::kZip));
  library_.restart();
  EXPECT_EQ(pages().level_pages, head.level_pages);
}

TEST_F(SheetStore, AScanThatIsRemovedTakesItsSheetsAlong) {
  ASSERT_TRUE(has_sheets());
  ASSERT_TRUE(library_.store->remove(scan_.id).is_ok());
  EXPECT_FALSE(fs::exists(path()));
  EXPECT_EQ(read_first().code(), StatusCode::kFailedPrecondition);
}

TEST_F(SheetStore, SheetsOfAnotherFormatGoAtTheNextStart) {
  ASSERT_TRUE(has_sheets());
  const fs::path old = path().parent_path() / "sheets-format0.sheets";
  fs::copy_file(path(), old);
  remove_stale_files(*library_.folder);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(path()));
}

/// A library with a square of photos whose seams may be levelled.
class LevelledStore : public SheetStore {
 protected:
  LevelledStore() {
    const std::vector<uint8_t> zip = zip_of(grid_);
    scan_ = library_.import({zip.begin(), zip.end()}, "grid", {}, 5, MeshFormat::kZip).value().scan;
  }

  fs::path path_of(uint64_t version) const {
    return path().parent_path() / sheets_file_name(version);
  }
  /// Returns the version of the sheets; 0 if they cannot be described.
  uint64_t level(double amount, std::span<const float> free = {}) {
    const auto description = library_.store->describe_sheets(scan_.id, {}, {amount, free});
    EXPECT_TRUE(description.is_ok()) << description.status().to_string();
    return description.is_ok() ? description->version : 0;
  }
  Status read_of(uint64_t version) { return read({"", {}, {}, {{0, 0}}, version}); }
  size_t vertices() const { return size_t(grid_.side() + 1) * size_t(grid_.side() + 1); }

  const PhotoGrid grid_;
};

TEST_F(LevelledStore, LevelledSheetsLieBesideTheScansOwn) {
  EXPECT_EQ(level(0), 0u);
  const std::string own = content_of(path());
  const uint64_t version = level(1);
  ASSERT_NE(version, 0u);
  ASSERT_TRUE(read_of(version).is_ok());
  const auto levelled = sheets_.at(0).bytes;
  ASSERT_TRUE(read_first().is_ok());
  EXPECT_NE(sheets_.at(0).bytes, levelled);
  EXPECT_TRUE(content_of(path()) == own);
  EXPECT_TRUE(fs::exists(path_of(version)));
}

TEST_F(LevelledStore, AVersionIsOfTheAmountAndTheRegion) {
  const uint64_t version = level(1);
  EXPECT_EQ(level(1), version);
  const std::vector<float> all(vertices(), 1.F);
  EXPECT_EQ(level(1, all), version);
  std::vector<float> part = all;
  part[0] = 0.5F;
  const std::set<uint64_t> versions = {0, version, level(0.5), level(1, part)};
  EXPECT_EQ(versions.size(), 4u);
}

TEST_F(LevelledStore, AVersionThatNobodyDescribedIsNotThere) {
  const uint64_t version = level(1);
  const Status other = read_of(version + 1);
  EXPECT_EQ(other.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(other.message(), HasSubstr(std::to_string(version + 1)));
  EXPECT_THAT(other.message(), HasSubstr("DescribeSheets"));
  library_.restart();
  EXPECT_TRUE(read_of(version).is_ok());
}

TEST_F(LevelledStore, OnlyTheLastFourWishesAreKept) {
  std::vector<uint64_t> versions;
  for (const double amount : {0.2, 0.3, 0.4, 0.5}) versions.push_back(level(amount));
  EXPECT_EQ(level(0.2), versions[0]);
  ASSERT_TRUE(read_of(versions[1]).is_ok());
  versions.push_back(level(0.6));
  EXPECT_TRUE(read_of(versions[1]).is_ok());  // it is open
  library_.restart();
  EXPECT_EQ(read_of(versions[1]).code(), StatusCode::kFailedPrecondition);
  for (const size_t kept : {0, 2, 3, 4}) EXPECT_TRUE(read_of(versions[kept]).is_ok()) << kept;
}

TEST_F(LevelledStore, ADamagedVersionIsMadeAgainAndTheOthersStay) {
  const uint64_t version = level(1), other = level(0.5);
  std::fstream(path_of(version), std::ios::in | std::ios::out | std::ios::binary)
      .seekp(100)
      .put('\x5a');
  EXPECT_EQ(read_of(version).code(), StatusCode::kDataLoss);
  EXPECT_EQ(read_of(version).code(), StatusCode::kFailedPrecondition);
  EXPECT_TRUE(read_of(other).is_ok());
  EXPECT_EQ(level(1), version);
  EXPECT_TRUE(read_of(version).is_ok());
}

TEST_F(LevelledStore, AFailureSaysNothingOfTheScansPictures) {
  const std::vector<float> too_few(3, 1.F);
  EXPECT_FALSE(library_.store->describe_sheets(scan_.id, {}, {1, too_few}).is_ok());
  EXPECT_TRUE(has_sheets());
}

TEST_F(LevelledStore, LevellingCanBeCancelledInEachPhase) {
  for (const std::string cancelled : {"levelling seams", "pictures", "sheets"}) {
    const Progress cancel = [&](std::string_view phase, double) { return phase != cancelled; };
    EXPECT_EQ(library_.store->describe_sheets(scan_.id, cancel, {1}).status().code(),
              StatusCode::kCancelled)
        << cancelled;
  }
  EXPECT_FALSE(fs::exists(path_of(seams_version({1}))));
}

/// Calls for levelled sheets, the second of which comes while the first one makes some.
class WishedTogether : public LevelledStore {
 protected:
  ~WishedTogether() override {
    if (second_.joinable()) second_.join();
  }

  Result<SheetsDescription> level_for(const std::string& user, double amount,
                                      const Progress& progress) {
    return library_.store->describe_sheets(scan_.id, progress, {amount}, user);
  }

  /// Wishes seams as the first caller, whose call is cancelled as soon as it levels and the second
  /// one waits. `then` is called each time that it is asked again.
  Status make_until_second_waits(double amount, double second_amount,
                                 const std::function<void()>& then) {
    bool has_second = false;
    const Progress first = [&](std::string_view phase, double) {
      if (has_second) then();
      if (has_second || phase != "levelling seams") return !has_second;
      has_second = true;
      second_ = std::thread([this, second_amount] { wish_as_second(second_amount); });
      is_waiting_.get_future().wait();
      return false;
    };
    return level_for("ann", amount, first).status();
  }

  Result<SheetsDescription> second_result() {
    second_.join();
    return *second_result_;
  }

  std::atomic<bool> second_goes_on_{true};
  std::set<std::string> second_phases_;

 private:
  void wish_as_second(double amount) {
    const Progress progress = [&](std::string_view phase, double) {
      if (second_phases_.empty()) is_waiting_.set_value();
      second_phases_.emplace(phase);
      return second_goes_on_.load();
    };
    second_result_ = level_for("bob", amount, progress);
  }

  std::promise<void> is_waiting_;
  std::optional<Result<SheetsDescription>> second_result_;
  std::thread second_;
};

TEST_F(WishedTogether, ACancelledCallMakesThemForSomebodyElseWhoWaits) {
  bool is_asked = false;
  const Status first = make_until_second_waits(1, 1, [&] { is_asked = true; });
  EXPECT_TRUE(first.is_ok()) << first.to_string();
  EXPECT_TRUE(is_asked);
  const auto second = second_result();
  ASSERT_TRUE(second.is_ok()) << second.status().to_string();
  EXPECT_EQ(second->version, seams_version({1}));
  EXPECT_EQ(second_phases_, std::set<std::string>{"waiting for another call for the scan"});
  EXPECT_TRUE(read_of(second->version).is_ok());
}

TEST_F(WishedTogether, AnotherWishHasItsTurnOnceTheCallIsCancelled) {
  bool is_asked = false;
  const Status first = make_until_second_waits(1, 0.5, [&] { is_asked = true; });
  EXPECT_EQ(first.code(), StatusCode::kCancelled);
  EXPECT_FALSE(is_asked);
  const auto second = second_result();
  ASSERT_TRUE(second.is_ok()) << second.status().to_string();
  EXPECT_EQ(second->version, seams_version({0.5}));
  EXPECT_FALSE(fs::exists(path_of(seams_version({1}))));
  const std::string made = content_of(path_of(second->version));
  fs::remove(path_of(second->version));
  library_.restart();
  ASSERT_TRUE(level_for("ann", 0.5, {}).is_ok());
  EXPECT_TRUE(content_of(path_of(second->version)) == made);
}

TEST_F(WishedTogether, NothingIsMadeOnceAllAreCancelled) {
  const Status first = make_until_second_waits(1, 1, [&] {
    if (!second_goes_on_.exchange(false)) return;
    EXPECT_EQ(second_result().status().code(), StatusCode::kCancelled);
  });
  EXPECT_EQ(first.code(), StatusCode::kCancelled);
  EXPECT_FALSE(fs::exists(path_of(seams_version({1}))));
}

TEST_F(LevelledStore, LevellingBeyondTheMemoryIsRefused) {
  library_.restart({.memory_bytes_max = 8 << 20});
  EXPECT_EQ(library_.store->describe_sheets(scan_.id, {}, {1}).status().code(),
            StatusCode::kResourceExhausted);
}

TEST_F(LevelledStore, AnyNumberOfThreadsMakesTheSameBytes) {
  const uint64_t version = level(1);
  const std::string all = content_of(path_of(version));
  fs::remove(path_of(version));
  library_.restart({.threads = 1});
  EXPECT_EQ(level(1), version);
  EXPECT_TRUE(content_of(path_of(version)) == all);
}

TEST_F(LevelledStore, AScanThatIsRemovedTakesItsVersionsAlong) {
  const uint64_t version = level(1);
  ASSERT_TRUE(library_.store->remove(scan_.id).is_ok());
  EXPECT_FALSE(fs::exists(path_of(version)));
  EXPECT_EQ(read_of(version).code(), StatusCode::kFailedPrecondition);
}

TEST_F(LevelledStore, LevelledSheetsOfAnotherFormatGoAtTheNextStart) {
  const uint64_t version = level(1);
  const fs::path old = path().parent_path() / "sheets-format0-seams00000000000000ff.sheets";
  fs::copy_file(path_of(version), old);
  remove_stale_files(*library_.folder);
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(path_of(version)));
}

}  // namespace
}  // namespace burnish
