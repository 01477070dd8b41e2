#include "server/manager/page_values.h"

#include <algorithm>
#include <limits>

#include "common/page_frames/page_evaluation.h"

namespace burnish {

PageValues page_values(const Page& page, int bits, const SparseGrid& grid,
                       std::span<const float> cell_values) {
  const auto points = make_page_evaluation(page, bits, grid, PageFrameKind::kVertices).points;
  constexpr float kUnset = std::numeric_limits<float>::max();
  float low = kUnset;
  for (const EvaluationPoint& point : points)
    if (point.cell != kNone) low = std::min(low, cell_values[point.cell]);
  if (low == kUnset) low = 0;
  std::vector<float> values;
  values.reserve(points.size());
  for (const EvaluationPoint& point : points)
    values.push_back(point.cell == kNone ? low : cell_values[point.cell]);
  return pack_page_values(page.id, values);
}

}  // namespace burnish
