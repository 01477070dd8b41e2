#include "common/grid/depth_plan.h"

#include "common/grid/grid.h"

namespace burnish {

// As measured on scans of terrain and heads.
static constexpr double kCellsPerCellArea = 1.4;
static constexpr double kBytesPerCell = 2950;
static constexpr double kSecondsPerCell = 20e-6;

DepthPlan plan_depth(const MeshStatistics& statistics, int depth) {
  DepthPlan plan;
  plan.depth = depth;
  plan.cell_size = make_grid_frame(statistics.box_min, statistics.box_max, depth).cell_size;
  plan.cells = kCellsPerCellArea * statistics.area / (plan.cell_size * plan.cell_size);
  plan.memory_bytes = kBytesPerCell * plan.cells;
  plan.prepare_seconds = kSecondsPerCell * plan.cells;
  return plan;
}

}  // namespace burnish
