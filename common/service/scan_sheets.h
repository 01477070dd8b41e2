#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/base/record.h"
#include "common/service/scan_pages.h"

namespace burnish {

/// Limit of the blocks, charts and sheets of one request.
inline constexpr size_t kSheetPartsPerFetchMax = 64;

/// Limit of the bytes of one request's sheets together. The directory says how many each has.
inline constexpr uint64_t kSheetBytesPerFetchMax = uint64_t{32} << 20;

/// Names a sheet of a scan.
struct SheetNumber {
  uint32_t page = 0;
  uint32_t halving = 0;  ///< 0 is the finest sheet of the page

  bool operator==(const SheetNumber&) const = default;
};

/// The directory blocks, charts and sheets that a client wants to have.
struct SheetsWish {
  std::string scan;  ///< name, id, or the beginning of one id
  std::vector<uint32_t> blocks;
  std::vector<uint32_t> charts;  ///< numbers of pages
  std::vector<SheetNumber> sheets;
  uint64_t version = 0;  ///< SheetsDescription::version
};
BURNISH_RECORD(SheetsWish, scan, blocks, charts, version)

/// An encoded sheet, in the format of common/sheets/sheet_format.h.
struct SheetPart {
  SheetNumber number;
  std::vector<uint8_t> bytes;
};

/// An encoded head of a sheet file and the coarsest blocks of its directory.
struct SheetsDescription {
  std::vector<uint8_t> head;     ///< empty: the scan has no pictures
  std::vector<PagePart> blocks;  ///< rising; the last holds the root
  uint64_t version = 0;          ///< of levelled sheets; 0: the scan's own

  bool has_sheets() const { return !head.empty(); }
};

}  // namespace burnish
