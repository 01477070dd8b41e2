#include "server/prepare/sheets/sheets_need.h"

#include <algorithm>
#include <string>

#include "common/base/parallel.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

// Bytes of memory.
static constexpr uint64_t kBytesPerThread = 64 << 20;  // a page's sheets, its finer pages', tiles
static constexpr uint64_t kBytesPerTriangle = 40;      // of the finder; charts of two levels
static constexpr uint64_t kBytesPerVertex = 48;        // of the finder

SheetsNeed::SheetsNeed(const MeshView& mesh, const SheetsOptions& options,
                       PreparationBudget& budget)
    : budget_(budget), held_bytes_(options.held_bytes) {
  const uint64_t arrays =
      mesh.triangles.size() * kBytesPerTriangle + mesh.vertices.size() * kBytesPerVertex;
  arrays_in_memory_ = std::min(arrays, options.space.memory_bytes_max());
  arrays_in_files_ = arrays - arrays_in_memory_;
  need_.counts.triangles = mesh.triangles.size();
  need_.counts.vertices = mesh.vertices.size();
}

Status SheetsNeed::ask_for_picture(uint64_t memory_bytes, uint64_t scratch_bytes) {
  return ask(memory_bytes, scratch_bytes, 0);
}

Status SheetsNeed::ask_for_pages(size_t pages) {
  constexpr double kAllHalvings = 4.0 / 3;
  constexpr double kSheetTexelsMax = double{kSheetSideMax} * kSheetSideMax;
  const auto texels =
      static_cast<uint64_t>(kAllHalvings * kSheetTexelsMax * static_cast<double>(pages));
  const auto threads = static_cast<uint64_t>(thread_count());
  return ask(arrays_in_memory_ + threads * kBytesPerThread,
             arrays_in_files_ + texels * sizeof(Rgba8), texels);
}

Status SheetsNeed::ask(uint64_t memory_bytes, uint64_t scratch_bytes, uint64_t file_bytes) {
  need_.memory_bytes = held_bytes_ + memory_bytes;
  need_.scratch_bytes = scratch_bytes;
  need_.file_bytes = file_bytes;
  return budget_.ask(need_).with_context("making sheets of " +
                                         std::to_string(need_.counts.triangles) + " triangles");
}

}  // namespace burnish
