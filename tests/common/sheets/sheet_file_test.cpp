#include "common/sheets/sheet_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/sheets/made_sheets.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::string sheet_content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Opens a file and reads all of it.
Status read_six_pages(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(const SheetFile file,
                   SheetFile::open(path, six_page_head(), kMadeOrigin.pages_fingerprint));
  static const std::vector<MadeSheets> pages = six_pages();
  for (const MadeSheets& made : pages) {
    RETURN_IF_ERROR(file.read_charts(made.page).status());
    for (size_t s = 0; s < file.sheet_entries(made.page.id).size(); ++s)
      RETURN_IF_ERROR(file.read_sheet(made.page.id, s).status());
  }
  return Status::ok();
}

class SheetFileTest : public testing::Test {
 protected:
  void SetUp() override { write_six_pages(path_); }

  SheetFile opened() const {
    return SheetFile::open(path_, six_page_head(), kMadeOrigin.pages_fingerprint).value();
  }

  /// Returns the message for a file with another content.
  std::string message_for(const std::string& content) const {
    std::ofstream(folder_ / "spoilt", std::ios::binary) << content;
    return read_six_pages(folder_ / "spoilt").message();
  }

  TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "sheets";
};

TEST_F(SheetFileTest, EverySheetComesBack) {
  const SheetFile file = opened();
  for (const MadeSheets& made : six_pages()) {
    const PageId page = made.page.id;
    EXPECT_EQ(file.read_charts(made.page).value(), made.charts);
    EXPECT_EQ(file.chart_entry(page).density, made.sheets[0].density);
    ASSERT_EQ(file.sheet_entries(page).size(), made.sheets.size());
    for (size_t s = 0; s < made.sheets.size(); ++s) {
      const Sheet sheet = file.read_sheet(page, s).value();
      EXPECT_EQ(sheet.layout, made.sheets[s].layout);
      EXPECT_EQ(sheet.density, made.sheets[s].density);
      EXPECT_EQ(file.sheet_entries(page)[s].width, sheet.layout.width);
    }
  }
}

TEST_F(SheetFileTest, TheHeadSaysWhatTheWriterWasTold) {
  const SheetFile file = opened();
  EXPECT_EQ(file.head().pages_fingerprint, 11u);
  EXPECT_EQ(file.head().pictures_fingerprint, 22u);
  EXPECT_EQ(file.head().blocks.size(), 3u);
}

TEST_F(SheetFileTest, TheSamePagesGiveTheSameBytes) {
  write_six_pages(folder_ / "again");
  EXPECT_EQ(sheet_content(folder_ / "again"), sheet_content(path_));
}

TEST_F(SheetFileTest, SheetsOfOtherPagesAreRefused) {
  const Status status = SheetFile::open(path_, six_page_head(), 12).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("11, not to 12"));
  PageHead other = six_page_head();
  other.level_pages = {3, 1};
  EXPECT_THAT(SheetFile::open(path_, other, 11).status().message(),
              HasSubstr("3 blocks are outside 2..2"));
  other.level_pages = {4, 2, 1};
  EXPECT_THAT(SheetFile::open(path_, other, 11).status().message(),
              HasSubstr("3 pages are outside 4..4"));
}

TEST_F(SheetFileTest, AFileThatIsNotWrittenToItsEndIsNotThere) {
  {
    const auto writer = SheetFileWriter::create(folder_ / "part", kMadeOrigin);
    ASSERT_TRUE(writer.is_ok());
  }
  EXPECT_EQ(read_six_pages(folder_ / "part").code(), StatusCode::kNotFound);
}

TEST_F(SheetFileTest, ChangedBytesAreNoticed) {
  const std::string good = sheet_content(path_);
  EXPECT_EQ(message_for(good), "");
  for (size_t at = 0; at < good.size(); at += 37) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 4);
    EXPECT_NE(message_for(bad), "") << at;
  }
}

TEST_F(SheetFileTest, ShorterFilesAreNoticed) {
  const std::string good = sheet_content(path_);
  for (size_t size = 0; size < good.size(); size += 101)
    EXPECT_NE(message_for(good.substr(0, size)), "") << size;
  EXPECT_NE(message_for(good + "x"), "");
}

TEST(SheetHeadCodec, PlacesThatCannotBeAreNamed) {
  const auto message = [](auto spoil) {
    SheetHead head{.blocks = {{0, 300, 40}, {100, 320, 40}, {200, 340, 40}},
                   .sheet_bytes = 300,
                   .chart_bytes = 60,
                   .block_bytes = 120};
    spoil(head);
    return decode_sheet_head(encode_sheet_head(head), six_page_head()).status().message();
  };
  EXPECT_EQ(message([](SheetHead&) {}), "");
  EXPECT_THAT(message([](SheetHead& h) { h.blocks[0].sheet_begin = 1; }), HasSubstr("0..0"));
  EXPECT_THAT(message([](SheetHead& h) { h.blocks[1].sheet_begin = 300; }), HasSubstr("1..299"));
  EXPECT_THAT(message([](SheetHead& h) { h.blocks[2].sheet_begin = 100; }), HasSubstr("101..299"));
  EXPECT_THAT(message([](SheetHead& h) { h.blocks[2].chart_begin = 360; }), HasSubstr("321..359"));
  EXPECT_THAT(message([](SheetHead& h) { h.blocks[2].bytes = 41; }), HasSubstr("121..121"));
  EXPECT_THAT(message([](SheetHead& h) { h.blocks.pop_back(); }), HasSubstr("2 blocks"));
  EXPECT_THAT(message([](SheetHead& h) { h.sheet_bytes = 0; }), HasSubstr("0 bytes of sheets"));
}

TEST(SheetBlockCodec, EntriesThatCannotBeAreNamed) {
  const auto message = [](auto spoil) {
    const SheetHead head{.blocks = {{0, 300, 40}, {300, 390, 40}, {301, 391, 40}},
                         .sheet_bytes = 300 + 2,
                         .chart_bytes = 90};
    SheetBlock block{.begin = 0, .charts = {{30, 1}, {30, 2}, {30, 3}}};
    for (int page = 0; page < 3; ++page) block.sheets.add(std::vector<SheetEntry>{{100, 9, 1024}});
    spoil(block);
    return decode_sheet_block(encode_sheet_block(block), head, six_page_head(), 0)
        .status()
        .message();
  };
  EXPECT_EQ(message([](SheetBlock&) {}), "");
  EXPECT_THAT(message([](SheetBlock& b) { b.begin = 1; }), HasSubstr("1 as first page"));
  EXPECT_THAT(message([](SheetBlock& b) { b.charts[1].density = 0; }),
              HasSubstr("page 1: a density of 0"));
  EXPECT_THAT(message([](SheetBlock& b) { b.charts[1].bytes = 24; }),
              HasSubstr("24 bytes of charts"));
  EXPECT_THAT(message([](SheetBlock& b) { b.charts[1].bytes = 31; }),
              HasSubstr("91 bytes of its charts"));
  EXPECT_THAT(message([](SheetBlock& b) { b.sheets.item[2].bytes = 101; }),
              HasSubstr("301 bytes of its sheets"));
  EXPECT_THAT(message([](SheetBlock& b) { b.sheets.item[2].width = 8; }),
              HasSubstr("8 texels of width"));
  EXPECT_THAT(message([](SheetBlock& b) { b.sheets.item[2].height = 1025; }), HasSubstr("9..1024"));
  EXPECT_THAT(message([](SheetBlock& b) {
                b.sheets.start = {0, 0, 2, 3};
              }),
              HasSubstr("0 sheets of page 0"));
  EXPECT_THAT(message([](SheetBlock& b) {
                b.sheets.start = {0, 1, 2, 2};
              }),
              HasSubstr("0 sheets of page 2"));
}

}  // namespace
}  // namespace burnish
