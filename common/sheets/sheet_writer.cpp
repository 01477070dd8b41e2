#include <cstring>

#include "common/base/check.h"
#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_codec.h"
#include "common/sheets/sheet_file.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

namespace {

template <typename Header>
Header header_of(std::span<const uint8_t> bytes) {
  Header header;
  BURNISH_CHECK(bytes.size() > sizeof(header), "a record has a header and a body");
  std::memcpy(&header, bytes.data(), sizeof(header));
  return header;
}

}  // namespace

SheetFileWriter::SheetFileWriter(AtomicFile file, const SheetOrigin& origin)
    : file_(std::move(file)),
      head_{.pages_fingerprint = origin.pages_fingerprint,
            .pictures_fingerprint = origin.pictures_fingerprint} {}

Result<SheetFileWriter> SheetFileWriter::create(const std::filesystem::path& path,
                                                const SheetOrigin& origin) {
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(path));
  return SheetFileWriter(std::move(file), origin);
}

Status SheetFileWriter::add(std::span<const uint8_t> charts,
                            std::span<const std::vector<uint8_t>> sheets) {
  const auto page = static_cast<PageId>(charts_.size());
  BURNISH_CHECK(header_of<ChartHeader>(charts).page == page, "pages come in order");
  BURNISH_CHECK(!sheets.empty() && sheets.size() <= kSheetsPerPageMax, "a page has 1..8 sheets");
  std::vector<SheetEntry> entries;
  for (size_t s = 0; s < sheets.size(); ++s) {
    const auto header = header_of<SheetHeader>(sheets[s]);
    BURNISH_CHECK(header.page == page && header.halving == s, "sheets come in order");
    entries.push_back({static_cast<uint32_t>(sheets[s].size()), header.width, header.height});
    if (s == 0) charts_.push_back({static_cast<uint32_t>(charts.size()), header.density});
    head_.sheet_bytes += sheets[s].size();
    RETURN_IF_ERROR(file_.write(sheets[s]));
  }
  sheets_.add(entries);
  chart_bytes_.insert(chart_bytes_.end(), charts.begin(), charts.end());
  return Status::ok();
}

Status SheetFileWriter::write_blocks(const PageHead& pages) {
  uint64_t sheet_begin = 0;
  uint64_t chart_begin = head_.sheet_bytes;
  for (uint32_t b = 0; b < pages.block_count(); ++b) {
    const PageRange range = pages.pages_of(b);
    const SheetBlockPlace place{sheet_begin, chart_begin};
    SheetBlock block{.begin = range.begin};
    for (PageId page = range.begin; page < range.end; ++page) {
      block.charts.push_back(charts_[page]);
      block.sheets.add(sheets_[page]);
      chart_begin += charts_[page].bytes;
      for (const SheetEntry& sheet : sheets_[page]) sheet_begin += sheet.bytes;
    }
    const std::vector<uint8_t> bytes = encode_sheet_block(block);
    head_.blocks.push_back(place);
    head_.blocks.back().bytes = static_cast<uint32_t>(bytes.size());
    head_.block_bytes += bytes.size();
    RETURN_IF_ERROR(file_.write(bytes));
  }
  return Status::ok();
}

Status SheetFileWriter::finish(const PageHead& pages) {
  BURNISH_CHECK(charts_.size() == pages.page_count(), "each page has sheets");
  head_.chart_bytes = chart_bytes_.size();
  RETURN_IF_ERROR(file_.write(chart_bytes_));
  RETURN_IF_ERROR(write_blocks(pages));
  std::vector<uint8_t> bytes = encode_sheet_head(head_);
  const SheetTail tail{.head_bytes = static_cast<uint32_t>(bytes.size())};
  const auto* begin = reinterpret_cast<const uint8_t*>(&tail);
  bytes.insert(bytes.end(), begin, begin + sizeof(tail));
  RETURN_IF_ERROR(file_.write(bytes));
  return file_.commit();
}

}  // namespace burnish
