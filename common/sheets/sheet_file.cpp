#include "common/sheets/sheet_file.h"

#include <cmath>
#include <cstring>
#include <string>

#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_checks.h"
#include "common/sheets/sheet_codec.h"
#include "common/sheets/sheet_format.h"

namespace burnish {

namespace {

/// Checks that a sheet is the one that the directory lists.
Status check_listed(const Sheet& sheet, PageId page, size_t halving, const SheetEntry& entry,
                    float finest_density) {
  const std::string wanted =
      "sheet " + std::to_string(halving) + " of page " + std::to_string(page);
  if (sheet.page != page || sheet.halving != halving)
    return data_loss("sheet " + std::to_string(sheet.halving) + " of page " +
                     std::to_string(sheet.page) + " lies at the place of " + wanted);
  if (sheet.layout.width != entry.width || sheet.layout.height != entry.height)
    return data_loss(wanted + " has " + std::to_string(sheet.layout.width) + "x" +
                     std::to_string(sheet.layout.height) + " texels, the directory says " +
                     std::to_string(entry.width) + "x" + std::to_string(entry.height));
  const float density = std::ldexp(finest_density, -static_cast<int>(halving));
  if (sheet.density != density)
    return data_loss(wanted + " has a density of " + std::to_string(sheet.density) +
                     ", the directory says " + std::to_string(density));
  return Status::ok();
}

}  // namespace

Result<SheetFile> SheetFile::open(const std::filesystem::path& path, const PageHead& pages,
                                  uint64_t pages_fingerprint) {
  ASSIGN_OR_RETURN(FileReader reader, FileReader::open(path));
  SheetFile file(std::move(reader));
  Status status = file.read_head(pages);
  if (status.is_ok() && file.head_.pages_fingerprint != pages_fingerprint)
    status = failed_precondition("the sheets belong to the pages " +
                                 std::to_string(file.head_.pages_fingerprint) + ", not to " +
                                 std::to_string(pages_fingerprint));
  if (status.is_ok()) status = file.read_blocks(pages);
  if (!status.is_ok()) return status.with_context(path.string());
  return file;
}

Result<uint64_t> SheetFile::find_head() const {
  SheetTail tail;
  const uint64_t file_bytes = file_.file_bytes();
  if (file_bytes < sizeof(tail))
    return data_loss("the sheet file has " + std::to_string(file_bytes) + " bytes, its tail has " +
                     std::to_string(sizeof(tail)));
  const uint64_t tail_begin = file_bytes - sizeof(tail);
  ASSIGN_OR_RETURN(const std::vector<uint8_t> bytes, file_.read(tail_begin, sizeof(tail)));
  std::memcpy(&tail, bytes.data(), sizeof(tail));
  if (tail.magic != kSheetTailMagic) return data_loss("the sheet file does not end with BnSe");
  if (tail.head_bytes > tail_begin)
    return data_loss("the head has " + std::to_string(tail.head_bytes) + " bytes, the sheet file " +
                     std::to_string(file_bytes));
  return tail_begin - tail.head_bytes;
}

Status SheetFile::read_head(const PageHead& pages) {
  ASSIGN_OR_RETURN(const uint64_t begin, find_head());
  ASSIGN_OR_RETURN(head_bytes_, file_.read(begin, file_.file_bytes() - sizeof(SheetTail) - begin));
  ASSIGN_OR_RETURN(head_, decode_sheet_head(head_bytes_, pages));
  const uint64_t before = head_.sheet_bytes + head_.chart_bytes;
  if (before <= begin && begin - before == head_.block_bytes) return Status::ok();
  return data_loss("the head says " + std::to_string(head_.sheet_bytes) + " bytes of sheets, " +
                   std::to_string(head_.chart_bytes) + " of charts and " +
                   std::to_string(head_.block_bytes) + " of blocks, but " + std::to_string(begin) +
                   " bytes lie before it");
}

Status SheetFile::read_blocks(const PageHead& pages) {
  block_offsets_.push_back(head_.sheet_bytes + head_.chart_bytes);
  sheet_offsets_.push_back(0);
  chart_offsets_.push_back(head_.sheet_bytes);
  for (uint32_t b = 0; b < head_.blocks.size(); ++b) {
    block_offsets_.push_back(block_offsets_.back() + head_.blocks[b].bytes);
    ASSIGN_OR_RETURN(const auto bytes, read_block_bytes(b));
    ASSIGN_OR_RETURN(const SheetBlock block, decode_sheet_block(bytes, head_, pages, b));
    for (size_t i = 0; i < block.charts.size(); ++i) {
      charts_.push_back(block.charts[i]);
      chart_offsets_.push_back(chart_offsets_.back() + block.charts[i].bytes);
      sheets_.add(block.sheets[i]);
      for (const SheetEntry& sheet : block.sheets[i])
        sheet_offsets_.push_back(sheet_offsets_.back() + sheet.bytes);
    }
  }
  return Status::ok();
}

Result<std::vector<uint8_t>> SheetFile::read_block_bytes(uint32_t block) const {
  ASSIGN_OR_RETURN(auto bytes, file_.read(block_offsets_[block], head_.blocks[block].bytes));
  const auto header = read_sealed<SheetBlockHeader>(bytes, bytes.size());
  RETURN_IF_ERROR(header.status().with_context("block " + std::to_string(block)));
  return bytes;
}

Result<std::vector<uint8_t>> SheetFile::read_chart_bytes(PageId page) const {
  ASSIGN_OR_RETURN(auto bytes, file_.read(chart_offsets_[page], charts_[page].bytes));
  const auto header = read_sealed<ChartHeader>(bytes, kChartBytesMax);
  RETURN_IF_ERROR(header.status().with_context("charts of page " + std::to_string(page)));
  return bytes;
}

Result<std::vector<uint8_t>> SheetFile::read_sheet_bytes(PageId page, size_t halving) const {
  const size_t sheet = static_cast<size_t>(sheets_.start[page]) + halving;
  ASSIGN_OR_RETURN(auto bytes, file_.read(sheet_offsets_[sheet], sheets_.item[sheet].bytes));
  const auto header = read_sealed<SheetHeader>(bytes, kSheetBytesMax);
  RETURN_IF_ERROR(header.status().with_context("sheet " + std::to_string(halving) + " of page " +
                                               std::to_string(page)));
  return bytes;
}

Result<PageCharts> SheetFile::read_charts(const Page& page) const {
  ASSIGN_OR_RETURN(const auto bytes, read_chart_bytes(page.id));
  return decode_charts(bytes, page);
}

Result<Sheet> SheetFile::read_sheet(PageId page, size_t halving) const {
  ASSIGN_OR_RETURN(const auto bytes, read_sheet_bytes(page, halving));
  ASSIGN_OR_RETURN(Sheet sheet, decode_sheet(bytes));
  RETURN_IF_ERROR(
      check_listed(sheet, page, halving, sheets_[page][halving], charts_[page].density));
  return sheet;
}

uint64_t SheetFile::byte_count() const {
  return head_bytes_.capacity() + charts_.capacity() * sizeof(ChartEntry) + sheets_.byte_count() +
         (block_offsets_.capacity() + chart_offsets_.capacity() + sheet_offsets_.capacity()) *
             sizeof(uint64_t);
}

}  // namespace burnish
