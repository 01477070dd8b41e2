#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/groups.h"
#include "common/base/status.h"
#include "common/pages/directory.h"
#include "common/sheets/sheet_format.h"

namespace burnish {

/// The facts that a client must know of a sheet before it has the sheet.
struct SheetEntry {
  uint32_t bytes = 0;   ///< encoded
  uint16_t width = 0;   ///< texels
  uint16_t height = 0;  ///< texels

  bool operator==(const SheetEntry&) const = default;
};

/// The same of a page's charts and of its finest sheet.
struct ChartEntry {
  uint32_t bytes = 0;  ///< of the encoded charts
  float density = 0;   ///< of the finest sheet, texels per file unit

  bool operator==(const ChartEntry&) const = default;
};

/// The entries of one block: the same pages as in the page file's block.
struct SheetBlock {
  PageId begin = 0;  ///< the first of its pages
  std::vector<ChartEntry> charts;
  Groups<SheetEntry> sheets;  ///< per page, the finest first
};

/// The header of an encoded block, as it lies there (sheet_format.h).
struct SheetBlockHeader {
  std::array<char, 4> magic = kSheetBlockMagic;
  uint8_t version = kSheetFormatVersion;
  std::array<uint8_t, 3> zero8 = {};
  uint32_t begin = 0;
  uint32_t pages = 0;
  uint32_t sheets = 0;
  uint32_t zero32 = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(SheetBlockHeader) == kSheetBlockHeaderBytes);

/// Places of the parts of a block, as the head lists them.
struct SheetBlockPlace {
  uint64_t sheet_begin = 0;  ///< of the first of its sheets in the file, bytes
  uint64_t chart_begin = 0;  ///< of the first of its charts
  uint32_t bytes = 0;        ///< of the encoded block

  bool operator==(const SheetBlockPlace&) const = default;
};

/// The part of the sheet file that a client reads first.
struct SheetHead {
  uint64_t pages_fingerprint = 0;     ///< of the page file to which the sheets belong
  uint64_t pictures_fingerprint = 0;  ///< of the pictures from which they are baked
  std::vector<SheetBlockPlace> blocks;
  uint64_t sheet_bytes = 0;  ///< of all sheets; the charts follow them in the file
  uint64_t chart_bytes = 0;  ///< of all charts; the blocks follow them
  uint64_t block_bytes = 0;  ///< of all blocks

  /// Return the ends of a block's sheets and charts in the file. Needs: a block.
  uint64_t sheet_end(size_t block) const;
  uint64_t chart_end(size_t block) const;
};

/// Packs the head in the format of sheet_format.h.
std::vector<uint8_t> encode_sheet_head(const SheetHead& head);

/// Safe for any bytes. Fails: data_loss that names the damage, also if it has not a block for each
/// of the pages' blocks; unimplemented (another version).
Result<SheetHead> decode_sheet_head(std::span<const uint8_t> bytes, const PageHead& pages);

/// Packs one block. Needs: 1..kPagesPerBlock pages with 1..kSheetsPerPageMax sheets each.
std::vector<uint8_t> encode_sheet_block(const SheetBlock& block);

/// Safe for any bytes. Fails: data_loss that names the damage, also if the block is not the one
/// that the heads list at `index`; unimplemented (another version).
Result<SheetBlock> decode_sheet_block(std::span<const uint8_t> bytes, const SheetHead& head,
                                      const PageHead& pages, uint32_t index);

}  // namespace burnish
