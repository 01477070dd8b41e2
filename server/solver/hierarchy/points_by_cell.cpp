#include "server/solver/hierarchy/points_by_cell.h"

#include <numeric>

namespace burnish {

// A counting sort.
PointsByCell sort_by_cell(std::span<const EvaluationPoint> points, int32_t cell_count) {
  PointsByCell sorted;
  sorted.start.assign(cell_count + 1, 0);
  for (const EvaluationPoint& point : points)
    if (point.cell != kNone) ++sorted.start[point.cell + 1];
  std::partial_sum(sorted.start.begin(), sorted.start.end(), sorted.start.begin());
  sorted.local.resize(sorted.start.back());
  std::vector<int32_t> next(sorted.start.begin(), sorted.start.end() - 1);
  for (const EvaluationPoint& point : points)
    if (point.cell != kNone) sorted.local[next[point.cell]++] = point.local;
  return sorted;
}

}  // namespace burnish
