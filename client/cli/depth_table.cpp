#include "client/cli/depth_table.h"

#include <cstdio>

#include "common/edit/wavelength.h"
#include "common/grid/depth_plan.h"

namespace burnish {

void print_depths(const MeshStatistics& statistics, int default_depth) {
  std::printf("%5s %12s %14s %12s %10s %10s\n", "depth", "cell size", "shortest wave", "cells",
              "MiB", "seconds");
  for (int depth = kDepthMin; depth <= kDepthMax; ++depth) {
    const DepthPlan plan = plan_depth(statistics, depth);
    std::printf("%5d %12.4g %14.4g %12.3g %10.3g %10.2g%s\n", depth, plan.cell_size,
                kWaveCellsMin * plan.cell_size, plan.cells, plan.memory_bytes / (1 << 20),
                plan.prepare_seconds, depth == default_depth ? "  default" : "");
  }
}

nlohmann::ordered_json depths_to_json(const MeshStatistics& statistics, int default_depth) {
  auto depths = nlohmann::ordered_json::array();
  for (int depth = kDepthMin; depth <= kDepthMax; ++depth) {
    const DepthPlan plan = plan_depth(statistics, depth);
    depths.push_back({{"depth", depth},
                      {"cell_size", plan.cell_size},
                      {"shortest_wave", kWaveCellsMin * plan.cell_size},
                      {"cells", plan.cells},
                      {"memory_bytes", plan.memory_bytes},
                      {"seconds", plan.prepare_seconds},
                      {"is_default", depth == default_depth}});
  }
  return depths;
}

}  // namespace burnish
