#include "common/pages/page_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"
#include "tests/common/pages/made_pages.h"
#include "tests/common/pages/made_scan.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Opens a file and reads all of its pages.
Status read_all(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const PageFile file, PageFile::open(path));
  for (PageId page = 0; page < file.directory().head.page_count(); ++page)
    RETURN_IF_ERROR(file.read_page(page).status());
  return Status::ok();
}

class PageFileTest : public testing::Test {
 protected:
  void SetUp() override { write_made_scan(path_); }

  TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "pages";
};

TEST_F(PageFileTest, EveryPageComesBack) {
  const PageFile file = PageFile::open(path_).value();
  const std::vector<Page> pages = made_scan_pages();
  ASSERT_EQ(file.directory().head.page_count(), pages.size());
  for (const Page& page : pages) {
    const Page read = file.read_page(page.id).value();
    EXPECT_EQ(meaning_of(read), meaning_of(page));
    EXPECT_EQ(file.directory().entries[page.id].vertices, page.positions.size());
    EXPECT_EQ(file.directory().entries[page.id].bytes, encode_page(page).size());
  }
}

TEST_F(PageFileTest, CoarserListsFollowFromThePatches) {
  const PageFile file = PageFile::open(path_).value();
  const auto& coarser = file.directory().coarser;
  EXPECT_THAT(coarser[0], ElementsAre(2, 3));
  EXPECT_THAT(coarser[1], ElementsAre(2, 3));
  EXPECT_THAT(coarser[2], ElementsAre(4));
  EXPECT_TRUE(coarser[4].empty());
}

TEST_F(PageFileTest, TheHeadSaysWhatTheWriterWasTold) {
  const PageHead head = PageFile::open(path_).value().directory().head;
  EXPECT_EQ(head.grid.origin, made_scan().grid.origin);
  EXPECT_EQ(head.grid.bits, 16);
  EXPECT_TRUE(head.has_colours);
  EXPECT_EQ(head.scan_vertices, 24u);
  EXPECT_THAT(head.level_pages, ElementsAre(2, 2, 1));
}

TEST_F(PageFileTest, HeadAndBlocksDecodeByThemselves) {
  const PageFile file = PageFile::open(path_).value();
  const PageHead head = decode_head(file.head_bytes()).value();
  for (uint32_t block = 0; block < head.block_count(); ++block)
    EXPECT_TRUE(decode_block(file.block_bytes(block), head, block).is_ok()) << block;
}

TEST_F(PageFileTest, TheSameScanGivesTheSameBytes) {
  write_made_scan(folder_ / "again");
  EXPECT_EQ(content_of(folder_ / "again"), content_of(path_));
}

TEST_F(PageFileTest, EveryChangedByteIsNoticed) {
  const std::string good = content_of(path_);
  for (size_t at = 0; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    EXPECT_FALSE(read_all(folder_.write("bad", bad)).is_ok()) << at;
  }
}

TEST_F(PageFileTest, EveryShorterOrLongerFileIsDataLoss) {
  const std::string good = content_of(path_);
  for (size_t size = 0; size < good.size(); size += 7)
    EXPECT_EQ(read_all(folder_.write("bad", good.substr(0, size))).code(), StatusCode::kDataLoss)
        << size;
  EXPECT_EQ(read_all(folder_.write("bad", good + "x")).code(), StatusCode::kDataLoss);
  EXPECT_EQ(read_all(folder_.write("bad", "x" + good)).code(), StatusCode::kDataLoss);
}

TEST_F(PageFileTest, AMissingFileIsNotFoundAndAFolderIsRefused) {
  EXPECT_EQ(PageFile::open(folder_ / "none").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(PageFile::open(path_.parent_path()).status().code(), StatusCode::kInvalidArgument);
}

TEST_F(PageFileTest, APageInAnothersPlaceIsNamed) {
  std::string content = content_of(path_);
  const PageFile file = PageFile::open(path_).value();
  const auto bytes = file.page_bytes(0);
  ASSERT_GE(file.page_bytes(1).size(), 0u);
  // The header's number, and the checksum as it is: the checksum tells.
  content[8] = 1;
  const PageFile spoilt = PageFile::open(folder_.write("bad", content)).value();
  EXPECT_THAT(spoilt.read_page(0).status().message(), HasSubstr("page 1"));
  EXPECT_EQ(spoilt.page_bytes(0).size(), bytes.size());
}

TEST_F(PageFileTest, NothingIsLeftOfAFileThatIsNotFinished) {
  {
    auto writer = PageFileWriter::create(folder_ / "half", made_scan());
    ASSERT_TRUE(writer.is_ok());
    writer->begin_level();
    const Page page = made_scan_pages()[0];
    ASSERT_TRUE(writer->add(page, {}, encode_page(page)).is_ok());
  }
  EXPECT_EQ(folder_.file_count(), 1u);
}

TEST_F(PageFileTest, AScanOfOnePageHasARootOfLevelZero) {
  const std::filesystem::path path = folder_ / "one";
  auto writer = PageFileWriter::create(path, {.vertices = 4, .triangles = 2});
  ASSERT_TRUE(writer.is_ok());
  writer->begin_level();
  ASSERT_TRUE(writer->add(two_triangles(), {}, encode_page(two_triangles())).is_ok());
  ASSERT_TRUE(writer->finish().is_ok());
  const PageFile file = PageFile::open(path).value();
  EXPECT_EQ(file.directory().head.root(), 0u);
  EXPECT_EQ(meaning_of(file.read_page(0).value()), meaning_of(two_triangles()));
}

using PageFileDeathTest = PageFileTest;

TEST_F(PageFileDeathTest, AnErrorThatFallsTowardsTheRootStopsTheWriter) {
  auto writer = PageFileWriter::create(folder_ / "falls", made_scan());
  const std::vector<Page> pages = made_scan_pages();
  writer->begin_level();
  for (PageId page = 0; page < 2; ++page)
    ASSERT_TRUE(writer->add(pages[page], {.error = 2}, encode_page(pages[page])).is_ok());
  writer->begin_level();
  EXPECT_DEATH((void)writer->add(pages[2], {.error = 1}, encode_page(pages[2])), "error and edge");
}

}  // namespace
}  // namespace burnish
