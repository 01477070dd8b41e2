#include "server/solver/hierarchy/points_by_cell.h"

#include <utility>

#include "common/base/resize_touched.h"

namespace burnish {

PointsByCell sort_by_cell(std::span<const EvaluationPoint> points, int32_t cell_count) {
  Groups<int32_t> vertices = group_numbers(cell_count, static_cast<int32_t>(points.size()),
                                           [&](int32_t vertex) { return points[vertex].cell; });
  PointsByCell sorted;
  sorted.start = std::move(vertices.start);
  resize_touched(sorted.item, vertices.item.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < vertices.item.size(); ++i) sorted.item[i] = points[vertices.item[i]].local;
  return sorted;
}

}  // namespace burnish
