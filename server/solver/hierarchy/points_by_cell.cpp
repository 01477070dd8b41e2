#include "server/solver/hierarchy/points_by_cell.h"

namespace burnish {

PointsByCell sort_by_cell(std::span<const EvaluationPoint> points, int32_t cell_count) {
  return group_by<std::array<float, 3>>(cell_count, [&](auto&& add) {
    for (const EvaluationPoint& point : points)
      if (point.cell != kNone) add(point.cell, point.local);
  });
}

}  // namespace burnish
