#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "server/library/scan_record.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// A library with a sphere of 20,480 triangles: several pages.
class PageStore : public testing::Test {
 protected:
  PageStore() { scan_ = library_.import(sphere_file(1, 5), "ball").value().scan; }

  fs::path path() const { return library_.folder->scans() / scan_.id / pages_file_name(); }
  PageHead head() { return decode_head(describe().head).value(); }
  PagesDescription describe() { return library_.store->describe_pages(scan_.id, {}).value(); }

  Status read(const PagesWish& wish) {
    parts_.clear();
    const auto take = [this](const PagePart& part) { parts_.push_back(part); };
    return library_.store->read_pages(scan_.id, wish, {take, take}, {});
  }

  TestLibrary library_;
  ScanInfo scan_;
  std::vector<PagePart> parts_;  // of the last read
};

TEST_F(PageStore, AnImportMakesThePages) {
  EXPECT_TRUE(fs::exists(path()));
  EXPECT_TRUE(read({"", {}, {0}}).is_ok());
  EXPECT_EQ(head().scan_triangles, 20480u);
  EXPECT_GT(head().level_count(), 2);
}

TEST_F(PageStore, LevelZeroIsTheScan) {
  const PageHead head = this->head();
  size_t triangles = 0;
  for (PageId page = 0; page < head.level_begin(1); ++page) {
    ASSERT_TRUE(read({"", {}, {page}}).is_ok());
    const Page decoded = decode_page(parts_.at(0).bytes).value();
    EXPECT_TRUE(check_page_in_scan(decoded, page, head).is_ok());
    triangles += decoded.triangles.size();
  }
  EXPECT_EQ(triangles, 20480u);
}

TEST_F(PageStore, TheDescriptionEndsWithTheBlockOfTheRoot) {
  const PagesDescription description = describe();
  const PageHead head = decode_head(description.head).value();
  ASSERT_FALSE(description.blocks.empty());
  EXPECT_EQ(description.blocks.back().number, head.block_count() - 1);
  for (const PagePart& block : description.blocks)
    EXPECT_TRUE(decode_block(block.bytes, head, block.number).is_ok());
}

TEST_F(PageStore, PartsComeInTheOrderOfTheWish) {
  ASSERT_TRUE(read({"", {1, 0}, {2, 0, 1}}).is_ok());
  std::vector<uint32_t> numbers;
  for (const PagePart& part : parts_) numbers.push_back(part.number);
  EXPECT_EQ(numbers, (std::vector<uint32_t>{1, 0, 2, 0, 1}));
}

TEST_F(PageStore, ANumberThatTheScanDoesNotHaveIsRefused) {
  const std::string pages = std::to_string(head().page_count());
  const Status page = read({"", {}, {0, head().page_count()}});
  EXPECT_EQ(page.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(page.message(), HasSubstr("page " + pages));
  EXPECT_TRUE(parts_.empty());
  EXPECT_THAT(read({"", {head().block_count()}, {}}).message(),
              HasSubstr("block " + std::to_string(head().block_count())));
}

TEST_F(PageStore, PagesThatAreGoneAreRefusedUntilSomebodyAsksForTheDescription) {
  fs::remove(path());
  library_.restart();
  EXPECT_EQ(read({"", {}, {0}}).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(head().scan_triangles, 20480u);
  EXPECT_TRUE(read({"", {}, {0}}).is_ok());
}

TEST_F(PageStore, ADamagedPageIsRefusedAndThePagesAreMadeAgain) {
  std::fstream(path(), std::ios::in | std::ios::out | std::ios::binary).seekp(60).put('\x5a');
  EXPECT_EQ(read({"", {}, {0}}).code(), StatusCode::kDataLoss);
  EXPECT_EQ(read({"", {}, {0}}).code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(head().scan_triangles, 20480u);
  EXPECT_TRUE(read({"", {}, {0}}).is_ok());
}

TEST_F(PageStore, AFileThatWasCutIsMadeAgain) {
  fs::resize_file(path(), fs::file_size(path()) / 2);
  library_.restart();
  EXPECT_EQ(head().scan_triangles, 20480u);
  EXPECT_TRUE(read({"", {}, {0}}).is_ok());
}

TEST_F(PageStore, AFileThatIsCutWhileItIsOpenIsRefused) {
  ASSERT_TRUE(read({"", {}, {0}}).is_ok());
  fs::resize_file(path(), 10);
  EXPECT_EQ(read({"", {}, {0}}).code(), StatusCode::kDataLoss);
}

TEST_F(PageStore, MakingThemCanBeCancelled) {
  fs::remove(path());
  library_.restart();
  const Progress cancel = [](std::string_view, double) { return false; };
  EXPECT_EQ(library_.store->describe_pages(scan_.id, cancel).status().code(),
            StatusCode::kCancelled);
  EXPECT_FALSE(fs::exists(path()));
}

TEST_F(PageStore, MakingThemBeyondTheMemoryIsRefusedWithTheNumbers) {
  fs::remove(path());
  library_.restart({.memory_bytes_max = 1000});
  const Status status = library_.store->describe_pages(scan_.id, {}).status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("limits.memory_bytes_max is 1000"));
}

TEST_F(PageStore, AScanThatIsRemovedTakesItsPagesAlong) {
  ASSERT_TRUE(read({"", {}, {0}}).is_ok());
  ASSERT_TRUE(library_.store->remove(scan_.id).is_ok());
  EXPECT_FALSE(fs::exists(path()));
  EXPECT_EQ(read({"", {}, {0}}).code(), StatusCode::kFailedPrecondition);
}

}  // namespace
}  // namespace burnish
