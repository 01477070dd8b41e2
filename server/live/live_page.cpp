#include "server/live/live_page.h"

#include <algorithm>

#include "common/page_frames/page_corners.h"

namespace burnish {

PageSize measure_page(const Page& page, int bits, int depth) {
  return {static_cast<uint32_t>(page.positions.size()),
          static_cast<uint32_t>(page.triangles.size()),
          count_page_corners(page.positions, bits, depth)};
}

// Returns the cells of vertices, each once.
static std::vector<int32_t> cells_of(const PageEvaluation& vertices) {
  std::vector<int32_t> cells;
  cells.reserve(vertices.points.size());
  for (const EvaluationPoint& point : vertices.points)
    if (point.cell != kNone) cells.push_back(point.cell);
  std::ranges::sort(cells);
  cells.erase(std::ranges::unique(cells).begin(), cells.end());
  return cells;
}

LivePage make_live_page(const Page& page, const PageSize& size, int bits, const SparseGrid& grid,
                        PageFrameKind kind) {
  LivePage made;
  made.size = size;
  made.evaluation = make_page_evaluation(page, bits, grid, PageFrameKind::kVertices);
  made.cells = cells_of(made.evaluation);
  if (kind == PageFrameKind::kCorners)
    made.evaluation = make_page_evaluation(page, bits, grid, kind);
  else if (is_colours(page.id))
    made.colours = page.colours;
  return made;
}

}  // namespace burnish
