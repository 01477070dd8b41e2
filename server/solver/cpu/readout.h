#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "common/evaluation/evaluation.h"

namespace burnish::cpu {

/// Calls visit(v, E x) for the vertices [begin, end): zero if a vertex has no cell. Vertices come
/// in the order of their file, so neither their cells nor the cells' corners are near the last
/// ones. It prefetches both. Shapes: x has one entry per corner of the grid, with the columns of
/// Value.
template <typename Value, typename Visit>
void visit_vertices(const SparseGrid& grid, std::span<const EvaluationPoint> points,
                    const std::vector<Value>& x, size_t begin, size_t end, Visit&& visit) {
  constexpr size_t kCornersAhead = 16, kCellsAhead = 32;
  const auto corners_of = [&](size_t v) {
    const int32_t cell = points[std::min(v, points.size() - 1)].cell;
    return &grid.cell_corners[std::max(cell, 0)];
  };
  for (size_t v = begin; v < end; ++v) {
    __builtin_prefetch(corners_of(v + kCellsAhead));
    for (const int32_t corner : *corners_of(v + kCornersAhead)) __builtin_prefetch(&x[corner]);
    Value sum = Value::Zero();
    if (points[v].cell != kNone) {
      const auto weights = trilinear_weights(points[v].local);
      const auto& corners = *corners_of(v);
      for (int a = 0; a < kCornersPerCell; ++a)
        sum += static_cast<typename Value::Scalar>(weights[a]) * x[corners[a]];
    }
    visit(v, sum);
  }
}

}  // namespace burnish::cpu
