#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/pages/directory.h"
#include "common/sheets/sheet_directory.h"

namespace burnish {

/// The facts that the directory says of one page.
struct SheetFacts {
  ChartEntry charts;
  std::span<const SheetEntry> sheets;  ///< the finest first
};

/// The directory of a scan's sheets, as far as it has come.
class KnownSheets {
 public:
  /// Needs: the sheets are those of these pages.
  KnownSheets(SheetHead head, PageHead pages) : head_(std::move(head)), pages_(std::move(pages)) {
    blocks_.resize(head_.blocks.size());
  }

  const SheetHead& head() const { return head_; }
  const PageHead& pages() const { return pages_; }

  /// Takes an encoded block that has come. Fails: as decode_sheet_block(); data_loss for a number
  /// that is not one of a block.
  Status add(uint32_t block, std::span<const uint8_t> bytes);

  /// Returns nothing if the block is not known. Needs: a page of this block.
  std::optional<SheetFacts> find(uint32_t block, PageId page) const;

 private:
  SheetHead head_;
  PageHead pages_;
  std::vector<std::unique_ptr<const SheetBlock>> blocks_;
};

}  // namespace burnish
