#include "common/grid/depth_plan.h"

#include "common/grid/grid.h"

namespace burnish {

// As measured on scans of terrain and heads.
static constexpr double kCellsPerCellArea = 1.4;
static constexpr double kBytesPerCell = 2100;
static constexpr double kSecondsPerCell = 20e-6;

static constexpr int kDepthOfAnyScan = 9;

DepthPlan plan_depth(const MeshStatistics& statistics, int depth) {
  DepthPlan plan;
  plan.depth = depth;
  plan.cell_size = make_grid_frame(statistics.box_min, statistics.box_max, depth).cell_size;
  plan.cells = kCellsPerCellArea * statistics.area / (plan.cell_size * plan.cell_size);
  plan.memory_bytes = kBytesPerCell * plan.cells;
  plan.prepare_seconds = kSecondsPerCell * plan.cells;
  return plan;
}

static bool fits(const MeshStatistics& statistics, int depth, uint64_t memory_bytes_max) {
  const DepthPlan plan = plan_depth(statistics, depth);
  return plan.memory_bytes <= static_cast<double>(memory_bytes_max) &&
         (depth <= kDepthOfAnyScan || plan.cells <= static_cast<double>(statistics.triangles));
}

int default_depth(const MeshStatistics& statistics, uint64_t memory_bytes_max) {
  int depth = matching_depth(statistics.box_min, statistics.box_max, statistics.mean_edge_length);
  while (depth > kDepthMin && !fits(statistics, depth, memory_bytes_max)) --depth;
  return depth;
}

}  // namespace burnish
