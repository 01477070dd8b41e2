#include "client/report/depth_text.h"

#include <cstdio>

#include "client/report/length_text.h"
#include "common/grid/depth_plan.h"
#include "common/grid/grid.h"

namespace burnish {

std::string memory_text(double bytes) {
  constexpr double kMega = 1e6, kGiga = 1e9;
  char text[32];
  if (bytes < kGiga) {
    std::snprintf(text, sizeof text, bytes < 100 * kMega ? "%.2g MB" : "%.0f MB", bytes / kMega);
  } else {
    std::snprintf(text, sizeof text, bytes < 100 * kGiga ? "%.2g GB" : "%.0f GB", bytes / kGiga);
  }
  return text;
}

std::string edges_text(const MeshStatistics& scan, const std::string& unit, int depth) {
  std::string text = "the scan's own edges are " + length_text(scan.mean_edge_length, unit);
  const int matching = matching_depth(scan.box_min, scan.box_max, scan.mean_edge_length);
  if (depth >= matching) return text;
  const double more =
      plan_depth(scan, matching).memory_bytes - plan_depth(scan, depth).memory_bytes;
  return text + "; depth " + std::to_string(matching) + " matches them and takes about " +
         memory_text(more) + " more";
}

}  // namespace burnish
