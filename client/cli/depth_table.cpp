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

}  // namespace burnish
