#pragma once

#include <cstddef>
#include <cstdint>

#include "common/base/status.h"
#include "server/prepare/preparation_need.h"
#include "server/prepare/sheets/build_sheets.h"

namespace burnish {

/// Promises memory and disk to the budget before they are taken.
class SheetsNeed {
 public:
  /// Needs: the budget outlives this.
  SheetsNeed(const MeshView& mesh, const SheetsOptions& options, PreparationBudget& budget);

  /// A picture comes, before any array is there. Fails: as the budget does.
  Status ask_for_picture(uint64_t memory_bytes, uint64_t scratch_bytes);

  /// So many pages are made by all threads. Fails: as the budget does.
  Status ask_for_pages(size_t pages);

 private:
  Status ask(uint64_t memory_bytes, uint64_t scratch_bytes, uint64_t file_bytes);

  PreparationBudget& budget_;
  PreparationNeed need_;
  const uint64_t held_bytes_;
  uint64_t arrays_in_memory_ = 0;
  uint64_t arrays_in_files_ = 0;
};

}  // namespace burnish
