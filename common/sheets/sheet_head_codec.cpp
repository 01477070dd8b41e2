#include <bit>
#include <cstring>
#include <limits>
#include <string>

#include "common/base/limits.h"
#include "common/sheets/sheet_checks.h"
#include "common/sheets/sheet_directory.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "heads are written as they lie");

struct RawSheetHead {
  std::array<char, 4> magic = kSheetHeadMagic;
  uint8_t version = kSheetFormatVersion;
  uint8_t gutter = kSheetGutter;
  uint16_t zero16 = 0;
  uint64_t pages_fingerprint = 0;
  uint64_t pictures_fingerprint = 0;
  uint32_t blocks = 0;
  uint32_t zero32 = 0;
  uint64_t sheet_bytes = 0;
  uint64_t chart_bytes = 0;
  uint64_t block_bytes = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(RawSheetHead) == kSheetHeadHeaderBytes);

struct RawSheetBlockPlace {
  uint64_t sheet_begin;
  uint64_t chart_begin;
  uint32_t bytes;
  uint32_t zero;
};
static_assert(sizeof(RawSheetBlockPlace) == 24);

Status check_sheet_head(const RawSheetHead& raw, uint32_t blocks, size_t bytes) {
  if (raw.zero16 != 0 || raw.zero32 != 0) return data_loss("reserved bits are set");
  RETURN_IF_ERROR(check_sheet_value("texels of gutter", raw.gutter, kSheetGutter, kSheetGutter));
  RETURN_IF_ERROR(check_sheet_value("blocks", raw.blocks, blocks, blocks));
  const size_t wanted = sizeof(raw) + blocks * sizeof(RawSheetBlockPlace);
  RETURN_IF_ERROR(check_sheet_value("bytes of the head", bytes, wanted, wanted));
  const uint64_t sheets_max = uint64_t{kPagesMax} * kSheetsPerPageMax * kSheetBytesMax;
  RETURN_IF_ERROR(check_sheet_value("bytes of sheets", raw.sheet_bytes, 1, sheets_max));
  const uint64_t charts_max = uint64_t{kPagesMax} * kChartBytesMax;
  return check_sheet_value("bytes of charts", raw.chart_bytes, 1, charts_max);
}

/// Checks that sheets, charts and blocks fill their parts of the file without gaps.
Status check_block_places(const SheetHead& head) {
  uint64_t sheet_least = 0;
  uint64_t chart_least = head.sheet_bytes;
  uint64_t block_bytes = 0;
  for (size_t b = 0; b < head.blocks.size(); ++b) {
    const SheetBlockPlace& block = head.blocks[b];
    const std::string name = "block " + std::to_string(b);
    const uint64_t sheet_most = b == 0 ? 0 : head.sheet_bytes - 1;
    const uint64_t chart_end = head.sheet_bytes + head.chart_bytes;
    const uint64_t chart_most = b == 0 ? head.sheet_bytes : chart_end - 1;
    Status status =
        check_sheet_value("as first byte of sheets", block.sheet_begin, sheet_least, sheet_most);
    if (status.is_ok())
      status =
          check_sheet_value("as first byte of charts", block.chart_begin, chart_least, chart_most);
    if (!status.is_ok()) return status.with_context(name);
    sheet_least = block.sheet_begin + 1;
    chart_least = block.chart_begin + 1;
    block_bytes += block.bytes;
  }
  return check_sheet_value("bytes of blocks", head.block_bytes, block_bytes, block_bytes);
}

Result<SheetHead> decode_head_of(std::span<const uint8_t> bytes, const PageHead& pages) {
  ASSIGN_OR_RETURN(const auto raw,
                   read_sealed<RawSheetHead>(bytes, std::numeric_limits<uint32_t>::max()));
  RETURN_IF_ERROR(check_sheet_head(raw, pages.block_count(), bytes.size()));
  SheetHead head{.pages_fingerprint = raw.pages_fingerprint,
                 .pictures_fingerprint = raw.pictures_fingerprint,
                 .sheet_bytes = raw.sheet_bytes,
                 .chart_bytes = raw.chart_bytes,
                 .block_bytes = raw.block_bytes};
  for (uint32_t b = 0; b < raw.blocks; ++b) {
    RawSheetBlockPlace place;
    std::memcpy(&place, bytes.data() + sizeof(raw) + b * sizeof(place), sizeof(place));
    if (place.zero != 0) return data_loss("block " + std::to_string(b) + ": reserved bits are set");
    head.blocks.push_back({place.sheet_begin, place.chart_begin, place.bytes});
  }
  RETURN_IF_ERROR(check_block_places(head));
  return head;
}

}  // namespace

uint64_t SheetHead::sheet_end(size_t block) const {
  return block + 1 < blocks.size() ? blocks[block + 1].sheet_begin : sheet_bytes;
}

uint64_t SheetHead::chart_end(size_t block) const {
  return block + 1 < blocks.size() ? blocks[block + 1].chart_begin : sheet_bytes + chart_bytes;
}

std::vector<uint8_t> encode_sheet_head(const SheetHead& head) {
  std::vector<uint8_t> bytes(sizeof(RawSheetHead) +
                             head.blocks.size() * sizeof(RawSheetBlockPlace));
  uint8_t* to = bytes.data() + sizeof(RawSheetHead);
  for (const SheetBlockPlace& block : head.blocks) {
    const RawSheetBlockPlace place{block.sheet_begin, block.chart_begin, block.bytes, 0};
    std::memcpy(to, &place, sizeof(place));
    to += sizeof(place);
  }
  seal_record(RawSheetHead{.pages_fingerprint = head.pages_fingerprint,
                           .pictures_fingerprint = head.pictures_fingerprint,
                           .blocks = static_cast<uint32_t>(head.blocks.size()),
                           .sheet_bytes = head.sheet_bytes,
                           .chart_bytes = head.chart_bytes,
                           .block_bytes = head.block_bytes},
              bytes);
  return bytes;
}

Result<SheetHead> decode_sheet_head(std::span<const uint8_t> bytes, const PageHead& pages) {
  auto head = decode_head_of(bytes, pages);
  if (!head.is_ok()) return head.status().with_context("head of sheets");
  return head;
}

}  // namespace burnish
