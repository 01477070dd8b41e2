#include "client/pages/cut_status.h"

#include <algorithm>
#include <cstdio>

namespace burnish {

namespace {

uint64_t block_triangles_in_view(const KnownBlock& block, const PageView& view,
                                 float largest_move) {
  uint64_t triangles = 0;
  for (const PageEntry& entry : block.directory.entries)
    if (is_visible(view, entry.bounds, largest_move)) triangles += entry.triangles;
  return triangles;
}

std::string megabytes_text(uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) * 1e-6);
  return text;
}

std::string reason_text(const CutStatus& status) {
  switch (status.reason) {
    case CutReason::kNone:
      return "";
    case CutReason::kLoading:
      return "loading, " + megabytes_text(status.bytes_left) + " left";
    case CutReason::kMoving:
      return "moving";
    case CutReason::kFrame:
      return "the link carries no more";
    case CutReason::kServer:
      return "the server has no memory for more";
    case CutReason::kTriangles:
      return "more is too much to draw";
    case CutReason::kMemory:
      return "more does not fit in memory";
    case CutReason::kCard:
      return "more does not fit on the graphics card";
    case CutReason::kFailed:
      return std::to_string(status.failed_items) + " pieces could not be loaded";
  }
  return "";
}

std::string count_text(uint64_t count) {
  char text[32];
  const auto value = static_cast<double>(count);
  if (value >= 1e6)
    std::snprintf(text, sizeof text, "%.3g M", value * 1e-6);
  else
    std::snprintf(text, sizeof text, "%.0f", value);
  return text;
}

}  // namespace

std::string status_text(const CutStatus& status) {
  if (status.is_full_detail) return "full detail";
  char percent[32];
  const double part = 100 * status.drawn_part();
  std::snprintf(percent, sizeof percent, part < 10 ? "%.2g %%" : "%.0f %%", part);
  return percent + (" of " + count_text(status.triangles_in_view)) +
         " triangles: " + reason_text(status);
}

std::string simplified_text(const CutStatus& status) {
  if (status.is_full_detail) return {};
  // A picture with all triangles in sight may have coarse ones at its border.
  const double percent = std::min(100 * status.drawn_part(), 99.0);
  char text[32];
  std::snprintf(text, sizeof text, percent < 10 ? "simplified, %.2g %%" : "simplified, %.0f %%",
                percent);
  return text;
}

double CutStatus::drawn_part() const {
  if (triangles_in_view == 0) return 1;
  return std::min(1.0,
                  static_cast<double>(triangles_drawn) / static_cast<double>(triangles_in_view));
}

uint64_t scan_triangles_in_view(const KnownPages& known, const PageView& view, float largest_move) {
  const PageHead& head = known.head();
  const double mean =
      static_cast<double>(head.scan_triangles) / static_cast<double>(head.level_pages[0]);
  uint64_t triangles = 0;
  for (uint32_t index = 0; index < known.level_zero_blocks(); ++index) {
    const PageBounds& bounds = head.blocks[index].bounds;
    if (!is_visible(view, bounds, largest_move)) continue;
    const KnownBlock* block = known.find_block(index);
    if (block == nullptr)
      triangles += static_cast<uint64_t>(mean * known.pages_of(index).count());
    else if (is_inside(view, bounds, largest_move))
      triangles += block->triangles;
    else
      triangles += block_triangles_in_view(*block, view, largest_move);
  }
  return triangles;
}

}  // namespace burnish
