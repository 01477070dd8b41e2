#include <cstring>
#include <vector>

#include "common/base/check.h"
#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_codec.h"
#include "common/sheets/sheet_directory.h"
#include "common/sheets/sheet_file.h"
#include "common/sheets/sheet_format.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/sealed_part.h"

namespace burnish {

namespace {

/// A bent square of eight triangles.
Page small_page() {
  Page page{.id = 5, .patches = {{kNoPage, 8}}};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) page.positions.emplace_back(1000 * x, 1000 * y, 900 * x * x);
  for (const int corner : {0, 1, 3, 4}) {
    const auto at = [corner](int step) { return static_cast<uint16_t>(corner + step); };
    page.triangles.push_back({at(0), at(1), at(3)});
    page.triangles.push_back({at(3), at(1), at(4)});
  }
  return page;
}

/// The head of three, two and one pages.
PageHead six_pages() {
  PageHead head;
  head.level_pages = {3, 2, 1};
  return head;
}

/// The head of their sheets, whose first block has 300 bytes of sheets and 90 of charts.
SheetHead small_sheet_head() {
  return {.blocks = {{0, 302, 40}, {300, 392, 40}, {301, 393, 40}},
          .sheet_bytes = 302,
          .chart_bytes = 92};
}

void seal_sheet_blocks(const SheetHead& head, std::span<uint8_t> blocks) {
  for (const SheetBlockPlace& block : head.blocks) {
    if (block.bytes > blocks.size()) return;
    seal_part(blocks.first(block.bytes), kSheetBlockHeaderBytes);
    blocks = blocks.subspan(block.bytes);
  }
}

void seal_sheet_file(std::span<uint8_t> file) {
  SheetTail tail;
  if (file.size() < sizeof(tail)) return;
  const size_t end = file.size() - sizeof(tail);
  std::memcpy(&tail, file.data() + end, sizeof(tail));
  if (tail.head_bytes > end) return;
  const auto head_bytes = file.subspan(end - tail.head_bytes, tail.head_bytes);
  seal_part(head_bytes, kSheetHeadHeaderBytes);
  const auto head = decode_sheet_head(head_bytes, six_pages());
  if (head.is_ok() && head->sheet_bytes + head->chart_bytes <= file.size())
    seal_sheet_blocks(*head, file.subspan(head->sheet_bytes + head->chart_bytes));
}

}  // namespace

bool read_fuzzed_charts(std::span<const uint8_t> bytes) {
  (void)decode_charts(bytes, small_page());
  const auto charts = decode_charts(compressed(bytes, kChartHeaderBytes), small_page());
  if (!charts.is_ok()) return false;
  const auto again = decode_charts(encode_charts(small_page().id, *charts), small_page());
  BURNISH_CHECK(again.is_ok() && *again == *charts, "charts do not read back");
  return true;
}

bool read_fuzzed_sheet(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> sealed(bytes.begin(), bytes.end());
  seal_part(sealed, kSheetHeaderBytes);
  const auto sheet = decode_sheet(sealed);
  if (!sheet.is_ok()) return false;
  BURNISH_CHECK(sheet->texels.size() == sheet->layout.texels(), "a sheet lacks texels");
  return true;
}

bool read_sheet_block(std::span<const uint8_t> bytes) {
  const auto decoded = [](std::span<const uint8_t> part) {
    return decode_sheet_block(part, small_sheet_head(), six_pages(), 0);
  };
  (void)decoded(bytes);
  const auto block = decoded(compressed(bytes, kSheetBlockHeaderBytes));
  if (!block.is_ok()) return false;
  const auto again = decoded(encode_sheet_block(*block));
  BURNISH_CHECK(again.is_ok() && again->charts == block->charts, "a block does not read back");
  return true;
}

bool read_sheet_file(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> sealed(bytes.begin(), bytes.end());
  seal_sheet_file(sealed);
  const MemoryFile in_memory(sealed);
  const auto file = SheetFile::open(in_memory.path(), six_pages(), 11);
  if (!file.is_ok()) return false;
  for (PageId page = 0; page < six_pages().page_count(); ++page) {
    (void)file->read_chart_bytes(page);
    for (size_t s = 0; s < file->sheet_entries(page).size(); ++s) (void)file->read_sheet(page, s);
  }
  return true;
}

}  // namespace burnish
