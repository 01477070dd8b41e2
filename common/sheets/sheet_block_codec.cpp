#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include "common/base/check.h"
#include "common/base/limits.h"
#include "common/packing/word_section.h"
#include "common/sheets/sheet_checks.h"
#include "common/sheets/sheet_directory.h"
#include "common/sheets/sheet_limits.h"
#include "common/sheets/webp_header.h"

namespace burnish {

namespace {

constexpr WordLayout kSheetWords{.word_bytes = 4, .difference_to = 1, .words_of_element = 1};
constexpr size_t kPageColumns = 3;   // bytes of the charts, sheets, density
constexpr size_t kSheetColumns = 2;  // bytes, sides
constexpr uint32_t kSheetsPerBlockMax = kPagesPerBlock * uint32_t{kSheetsPerPageMax};

Status check_block_header(const SheetBlockHeader& raw, const PageRange& pages) {
  if (raw.zero8 != std::array<uint8_t, 3>{} || raw.zero32 != 0)
    return data_loss("reserved bits are set");
  RETURN_IF_ERROR(check_sheet_value("as first page", raw.begin, pages.begin, pages.begin));
  RETURN_IF_ERROR(check_sheet_value("pages", raw.pages, pages.count(), pages.count()));
  return check_sheet_value("sheets", raw.sheets, raw.pages, kSheetsPerBlockMax);
}

Status check_chart_entry(const ChartEntry& entry) {
  RETURN_IF_ERROR(
      check_sheet_value("bytes of charts", entry.bytes, kChartHeaderBytes + 1, kChartBytesMax));
  return check_sheet_density(entry.density);
}

Status check_sheet_entry(const SheetEntry& entry) {
  RETURN_IF_ERROR(check_sheet_value("bytes of a sheet", entry.bytes,
                                    kSheetHeaderBytes + kWebpHeaderBytes, kSheetBytesMax));
  RETURN_IF_ERROR(
      check_sheet_value("texels of width", entry.width, kChartTexelsMin, kSheetSideMax));
  return check_sheet_value("texels of height", entry.height, kChartTexelsMin, kSheetSideMax);
}

/// Checks each entry, and that all fill the part of the file that the head gives to the block.
Status check_entries(const SheetBlock& block, const SheetHead& head, uint32_t index) {
  uint64_t chart_bytes = 0;
  uint64_t sheet_bytes = 0;
  for (size_t i = 0; i < block.charts.size(); ++i) {
    Status status = check_chart_entry(block.charts[i]);
    chart_bytes += block.charts[i].bytes;
    for (const SheetEntry& sheet : block.sheets[i]) {
      if (status.is_ok()) status = check_sheet_entry(sheet);
      sheet_bytes += sheet.bytes;
    }
    if (!status.is_ok()) return status.with_context("page " + std::to_string(block.begin + i));
  }
  const SheetBlockPlace& place = head.blocks[index];
  const uint64_t charts = head.chart_end(index) - place.chart_begin;
  const uint64_t sheets = head.sheet_end(index) - place.sheet_begin;
  RETURN_IF_ERROR(check_sheet_value("bytes of its charts", chart_bytes, charts, charts));
  return check_sheet_value("bytes of its sheets", sheet_bytes, sheets, sheets);
}

/// Cuts the words into entries. Fails: data_loss if a page has too few or too many sheets.
Status read_entries(std::span<const uint32_t> words, size_t sheets, SheetBlock& block) {
  const size_t pages = block.charts.size();
  auto of_sheets = words.subspan(kPageColumns * pages);
  size_t first = 0;
  for (size_t i = 0; i < pages; ++i) {
    block.charts[i] = {words[i], std::bit_cast<float>(words[2 * pages + i])};
    const size_t count = words[pages + i];
    const std::string name = "sheets of page " + std::to_string(block.begin + i);
    RETURN_IF_ERROR(check_sheet_value(name.c_str(), count, 1, kSheetsPerPageMax));
    RETURN_IF_ERROR(check_sheet_value(name.c_str(), count, 1, sheets - first));
    std::vector<SheetEntry> entries;
    for (size_t s = first; s < first + count; ++s) {
      const uint32_t sides = of_sheets[sheets + s];
      entries.push_back(
          {of_sheets[s], static_cast<uint16_t>(sides), static_cast<uint16_t>(sides >> 16)});
    }
    block.sheets.add(entries);
    first += count;
  }
  return check_sheet_value("sheets of its pages", first, sheets, sheets);
}

Result<SheetBlock> decode_block_of(std::span<const uint8_t> bytes, const SheetHead& head,
                                   const PageHead& pages, uint32_t index) {
  ASSIGN_OR_RETURN(const auto raw, read_sealed<SheetBlockHeader>(bytes, bytes.size()));
  RETURN_IF_ERROR(check_block_header(raw, pages.pages_of(index)));
  const size_t count = kPageColumns * raw.pages + kSheetColumns * raw.sheets;
  ASSIGN_OR_RETURN(const auto unpacked,
                   unpack_words(kSheetWords, bytes.subspan(sizeof(raw)), 4 * count));
  std::vector<uint32_t> words(count);
  std::memcpy(words.data(), unpacked.data(), unpacked.size());
  SheetBlock block{.begin = raw.begin, .charts = std::vector<ChartEntry>(raw.pages)};
  RETURN_IF_ERROR(read_entries(words, raw.sheets, block));
  RETURN_IF_ERROR(check_entries(block, head, index));
  return block;
}

}  // namespace

std::vector<uint8_t> encode_sheet_block(const SheetBlock& block) {
  const size_t pages = block.charts.size();
  BURNISH_CHECK(pages <= kPagesPerBlock, "the block has too many pages");
  std::vector<uint32_t> words;
  for (const ChartEntry& charts : block.charts) words.push_back(charts.bytes);
  for (size_t i = 0; i < pages; ++i) words.push_back(static_cast<uint32_t>(block.sheets[i].size()));
  for (const ChartEntry& charts : block.charts)
    words.push_back(std::bit_cast<uint32_t>(charts.density));
  for (const SheetEntry& sheet : block.sheets.item) words.push_back(sheet.bytes);
  for (const SheetEntry& sheet : block.sheets.item)
    words.push_back(sheet.width | uint32_t{sheet.height} << 16);
  const std::vector<uint8_t> section =
      pack_words(kSheetWords, {reinterpret_cast<const uint8_t*>(words.data()), 4 * words.size()});
  std::vector<uint8_t> bytes(kSheetBlockHeaderBytes + section.size());
  std::ranges::copy(section, bytes.begin() + kSheetBlockHeaderBytes);
  seal_record(SheetBlockHeader{.begin = block.begin,
                               .pages = static_cast<uint32_t>(pages),
                               .sheets = static_cast<uint32_t>(block.sheets.item.size())},
              bytes);
  return bytes;
}

Result<SheetBlock> decode_sheet_block(std::span<const uint8_t> bytes, const SheetHead& head,
                                      const PageHead& pages, uint32_t index) {
  auto block = decode_block_of(bytes, head, pages, index);
  if (!block.is_ok())
    return block.status().with_context("block " + std::to_string(index) + " of sheets");
  return block;
}

}  // namespace burnish
