#include "client/model/depth_choice.h"

#include <cstdio>

#include "client/report/length_text.h"
#include "common/edit/wavelength.h"
#include "common/grid/depth_plan.h"
#include "common/grid/grid.h"

namespace burnish {

// plan_depth() is within this factor for a smooth surface.
static constexpr double kPlanFactor = 1.5;

static std::string gigabytes(double bytes) {
  constexpr double kMega = 1e6, kGiga = 1e9;
  char text[32];
  if (bytes < kGiga) {
    std::snprintf(text, sizeof text, "%.2g MB", bytes / kMega);
    if (bytes >= 100 * kMega) std::snprintf(text, sizeof text, "%.0f MB", bytes / kMega);
  } else {
    std::snprintf(text, sizeof text, bytes < 100 * kGiga ? "%.2g GB" : "%.0f GB", bytes / kGiga);
  }
  return text;
}

static DepthChoice choice_of(const DepthPlan& plan, const std::string& unit,
                             uint64_t memory_bytes_max) {
  DepthChoice choice{plan.depth, {}, {}, false};
  const std::string memory = "about " + gigabytes(plan.memory_bytes);
  choice.text = "depth " + std::to_string(plan.depth) + ": details from " +
                length_text(kWaveCellsMin * plan.cell_size, unit) + ", cells of " +
                length_text(plan.cell_size, unit) + ", " + memory;
  const auto most = static_cast<double>(memory_bytes_max);
  if (memory_bytes_max > 0 && plan.memory_bytes > kPlanFactor * most)
    choice.refusal = "needs " + memory + ", the server here has " + gigabytes(most);
  return choice;
}

std::vector<DepthChoice> depth_choices(const MeshStatistics& scan, const std::string& unit,
                                       uint64_t memory_bytes_max) {
  const int usual = default_depth(scan.box_min, scan.box_max, scan.mean_edge_length);
  std::vector<DepthChoice> choices;
  for (int depth = kDepthMin; depth <= kDepthMax; ++depth) {
    choices.push_back(choice_of(plan_depth(scan, depth), unit, memory_bytes_max));
    choices.back().is_default = depth == usual;
  }
  return choices;
}

std::string edges_text(const MeshStatistics& scan, const std::string& unit) {
  return "the scan's own edges are " + length_text(scan.mean_edge_length, unit);
}

}  // namespace burnish
