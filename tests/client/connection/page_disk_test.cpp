#include "client/connection/page_disk.h"

#include <chrono>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/client/connection/fake_library.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kScan = 0xabcd;

std::vector<uint8_t> made(PageItem item) {
  return FakeLibrary::bytes_of(item);
}

void keep(PageDisk& disk, PageItem item) {
  disk.keep(item, made(item));
}

bool has(PageDisk& disk, PageItem item) {
  const auto found = disk.find(item);
  if (found.is_ok()) {
    EXPECT_EQ(*found, made(item));
  }
  return found.is_ok();
}

/// A folder of fetched pages.
class PageDisks : public testing::Test {
 protected:
  fs::path pages_file(const std::string& name = "000000000000abcd") const {
    return path_ / (name + ".pages");
  }
  fs::path index_file(const std::string& name = "000000000000abcd") const {
    return path_ / (name + ".index");
  }
  void fill(uint64_t scan, PageId pages) const {
    PageDisk disk(path_, scan);
    for (PageId page = 0; page < pages; ++page) keep(disk, PageItem::of_page(page));
  }
  static void flip(const fs::path& path, std::streamoff at) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(at);
    const char byte = static_cast<char>(file.get() ^ 1);
    file.seekp(at);
    file.put(byte);
  }

  const TemporaryFolder parent_;
  const fs::path path_ = parent_ / "pages";
  const PageItem page_ = PageItem::of_page(3);
  const PageItem block_ = PageItem::of_block(3);
};

TEST_F(PageDisks, KeepItemsFromOneRunToTheNext) {
  for (int run = 0; run < 3; ++run) {
    PageDisk disk(path_, kScan);
    EXPECT_EQ(has(disk, page_), run > 0);
    EXPECT_EQ(has(disk, block_), run > 1);
    keep(disk, page_);
    if (run > 0) keep(disk, block_);
    EXPECT_TRUE(has(disk, page_));
  }
}

TEST_F(PageDisks, KeepNoItemsOfSheets) {
  PageDisk disk(path_, kScan);
  for (const PageItem item :
       {PageItem::of_sheet_block(3), PageItem::of_charts(3), PageItem::of_sheet(3, 0)}) {
    disk.keep(item, FakeLibrary::bytes_of(page_));
    EXPECT_EQ(disk.find(item).status().code(), StatusCode::kNotFound);
  }
}

TEST_F(PageDisks, KnowNothingOfAnotherScan) {
  fill(kScan, 5);
  PageDisk other(path_, kScan + 1);
  EXPECT_EQ(other.find(page_).status().code(), StatusCode::kNotFound);
}

TEST_F(PageDisks, DoNotGrowByAnItemThatIsThere) {
  fill(kScan, 5);
  const auto bytes = fs::file_size(pages_file());
  fill(kScan, 5);
  EXPECT_EQ(fs::file_size(pages_file()), bytes);
  EXPECT_EQ(fs::file_size(index_file()), 5u * 32);
}

TEST_F(PageDisks, MissADamagedItemUntilItIsKeptAgain) {
  fill(kScan, 1);
  flip(pages_file(), 60);
  const PageItem first = PageItem::of_page(0);
  {
    PageDisk disk(path_, kScan);
    EXPECT_EQ(disk.find(first).status().code(), StatusCode::kDataLoss);
    EXPECT_EQ(disk.find(first).status().code(), StatusCode::kNotFound);
    keep(disk, first);
    EXPECT_TRUE(has(disk, first));
  }
  PageDisk disk(path_, kScan);
  EXPECT_TRUE(has(disk, first));
}

TEST_F(PageDisks, MissWhatTheFileIsTooShortFor) {
  fill(kScan, 5);
  fs::resize_file(pages_file(), fs::file_size(pages_file()) - 1);
  PageDisk disk(path_, kScan);
  EXPECT_TRUE(has(disk, PageItem::of_page(3)));
  EXPECT_FALSE(has(disk, PageItem::of_page(4)));
  keep(disk, PageItem::of_page(4));
  EXPECT_TRUE(has(disk, PageItem::of_page(4)));
}

TEST_F(PageDisks, IgnoreWhatFollowsADamagedRecord) {
  fill(kScan, 5);
  flip(index_file(), 2 * 32 + 4);
  {
    PageDisk disk(path_, kScan);
    EXPECT_TRUE(has(disk, PageItem::of_page(1)));
    EXPECT_FALSE(has(disk, PageItem::of_page(2)));
    EXPECT_FALSE(has(disk, PageItem::of_page(4)));
    for (PageId page = 2; page < 5; ++page) keep(disk, PageItem::of_page(page));
  }
  PageDisk disk(path_, kScan);
  for (PageId page = 0; page < 5; ++page) EXPECT_TRUE(has(disk, PageItem::of_page(page)));
}

TEST_F(PageDisks, IgnoreAHalfWrittenRecord) {
  fill(kScan, 5);
  fs::resize_file(index_file(), 4 * 32 + 9);
  PageDisk disk(path_, kScan);
  EXPECT_TRUE(has(disk, PageItem::of_page(3)));
  EXPECT_FALSE(has(disk, PageItem::of_page(4)));
  keep(disk, PageItem::of_page(4));
  EXPECT_TRUE(has(disk, PageItem::of_page(4)));
}

TEST_F(PageDisks, KeepNothingThatIsDamaged) {
  PageDisk disk(path_, kScan);
  std::vector<uint8_t> bytes = made(page_);
  bytes.back() ^= 1;
  disk.keep(page_, bytes);
  disk.keep(page_, {});
  EXPECT_EQ(disk.find(page_).status().code(), StatusCode::kNotFound);
}

TEST_F(PageDisks, KeepNothingBeyondTheirLimit) {
  const uint64_t room = made(PageItem::of_page(0)).size() + 32;
  PageDisk disk(path_, kScan, room);
  keep(disk, PageItem::of_page(0));
  keep(disk, PageItem::of_page(1));
  EXPECT_TRUE(has(disk, PageItem::of_page(0)));
  EXPECT_FALSE(has(disk, PageItem::of_page(1)));
}

TEST_F(PageDisks, RemoveTheScansThatWereNotUsedForTheLongestTime) {
  for (const uint64_t scan : {1, 2, 3}) fill(scan, 10);
  const auto now = fs::file_time_type::clock::now();
  const auto name = [](int scan) { return "000000000000000" + std::to_string(scan); };
  for (const int scan : {1, 2, 3})
    fs::last_write_time(index_file(name(scan)), now - std::chrono::hours(scan == 2 ? 9 : scan));
  const uint64_t of_one = fs::file_size(pages_file(name(1))) + 10 * 32;
  PageDisk disk(path_, kScan, 3 * of_one);
  keep(disk, page_);
  EXPECT_TRUE(has(disk, page_));
  EXPECT_TRUE(fs::exists(index_file(name(1))));
  EXPECT_FALSE(fs::exists(index_file(name(2))));
  EXPECT_FALSE(fs::exists(pages_file(name(2))));
  EXPECT_TRUE(fs::exists(pages_file(name(3))));
}

TEST_F(PageDisks, AreUsedByOneAtATime) {
  {
    PageDisk first(path_, kScan);
    keep(first, page_);
    PageDisk second(path_, kScan);
    EXPECT_FALSE(has(second, page_));
    keep(second, block_);
    EXPECT_FALSE(has(first, block_));
    EXPECT_TRUE(has(first, page_));
  }
  PageDisk third(path_, kScan);
  EXPECT_TRUE(has(third, page_));
}

TEST_F(PageDisks, AreForOneUserAlone) {
  fill(kScan, 1);
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_all);
  EXPECT_EQ(fs::status(index_file()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  fs::permissions(path_, fs::perms::all);
  PageDisk disk(path_, kScan);
  EXPECT_FALSE(has(disk, PageItem::of_page(0)));
}

TEST_F(PageDisks, AreOffWithoutAFolder) {
  const fs::path file = parent_.write("file", "");
  for (const fs::path& path : {fs::path(), file, file / "below"}) {
    PageDisk disk(path, kScan);
    keep(disk, page_);
    EXPECT_EQ(disk.find(page_).status().code(), StatusCode::kNotFound);
  }
}

}  // namespace
}  // namespace burnish
