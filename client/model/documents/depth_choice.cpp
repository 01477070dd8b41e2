#include "client/model/documents/depth_choice.h"

#include "client/report/depth_text.h"
#include "client/report/length_text.h"
#include "common/edit/wavelength.h"
#include "common/grid/depth_plan.h"

namespace burnish {

// plan_depth() is within this factor for a smooth surface.
static constexpr double kPlanFactor = 1.5;

static DepthChoice choice_of(const DepthPlan& plan, const std::string& unit,
                             uint64_t memory_bytes_max) {
  DepthChoice choice{plan.depth, {}, {}, false};
  const std::string memory = "about " + memory_text(plan.memory_bytes);
  choice.text = "depth " + std::to_string(plan.depth) + ": details from " +
                length_text(kWaveCellsMin * plan.cell_size, unit) + ", cells of " +
                length_text(plan.cell_size, unit) + ", " + memory;
  const auto most = static_cast<double>(memory_bytes_max);
  if (memory_bytes_max > 0 && plan.memory_bytes > kPlanFactor * most)
    choice.refusal = "needs " + memory + ", the server here has " + memory_text(most);
  return choice;
}

std::vector<DepthChoice> depth_choices(const MeshStatistics& scan, const std::string& unit,
                                       uint64_t memory_bytes_max, int server_default) {
  const uint64_t memory =
      memory_bytes_max > 0 ? memory_of_default_depth(memory_bytes_max) : UINT64_MAX;
  const int usual = server_default > 0 ? server_default : default_depth(scan, memory);
  std::vector<DepthChoice> choices;
  for (int depth = kDepthMin; depth <= kDepthMax; ++depth) {
    choices.push_back(choice_of(plan_depth(scan, depth), unit, memory_bytes_max));
    choices.back().is_default = depth == usual;
  }
  return choices;
}

}  // namespace burnish
