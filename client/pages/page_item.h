#pragma once

#include <compare>
#include <cstdint>

#include "common/pages/page.h"

namespace burnish {

/// Something that a client asks a server for: a page, or a block of the directory; or of the sheets
/// (common/sheets), a block of their directory, the charts of a page, or a sheet of it.
struct PageItem {
  enum class Kind : uint8_t { kBlock, kPage, kSheetBlock, kCharts, kSheet };

  uint32_t number = 0;  ///< of the page or the block
  Kind kind = Kind::kPage;
  uint8_t halving = 0;   ///< of a sheet: 0 is the finest of the page
  uint64_t version = 0;  ///< of the sheets' file: SheetsDescription::version

  static constexpr PageItem of_page(PageId page) { return {page, Kind::kPage}; }
  static constexpr PageItem of_block(uint32_t block) { return {block, Kind::kBlock}; }
  static constexpr PageItem of_sheet_block(uint32_t block, uint64_t version = 0) {
    return {block, Kind::kSheetBlock, 0, version};
  }
  static constexpr PageItem of_charts(PageId page, uint64_t version = 0) {
    return {page, Kind::kCharts, 0, version};
  }
  static constexpr PageItem of_sheet(PageId page, uint8_t halving, uint64_t version = 0) {
    return {page, Kind::kSheet, halving, version};
  }
  /// Returns whether the item is one of the sheets' file.
  bool is_of_sheets() const { return kind >= Kind::kSheetBlock; }
  auto operator<=>(const PageItem&) const = default;
};

/// An item that the current picture misses.
struct MissingItem {
  PageItem item;
  uint32_t bytes = 0;
  float excess = 0;  ///< as in WantedPage
};

/// Orders by urgency: most pixels of error first, coarse before fine, blocks before pages.
inline bool is_more_urgent(const MissingItem& one, const MissingItem& other) {
  if (one.excess != other.excess) return one.excess > other.excess;
  if (one.item.kind != other.item.kind) return one.item.kind < other.item.kind;
  return one.item.number > other.item.number;
}

}  // namespace burnish
