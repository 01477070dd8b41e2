#include "server/live/live_page.h"

#include <algorithm>

#include "common/page_frames/page_corners.h"

namespace burnish {

namespace {

// Spreads the bits of small numbers, so that sums of different vertices differ.
uint64_t mixed(uint64_t vertex) {
  vertex = (vertex + 1) * 0x9e3779b97f4a7c15;
  return (vertex ^ vertex >> 29) * 0xbf58476d1ce4e5b9;
}

// Returns the triangles with rising corners, and each of several copies once: they are no other
// surface (common/mesh/surface_triangles.h).
std::vector<PageTriangle> surface_of(const Page& page) {
  std::vector<PageTriangle> triangles = page.triangles;
  for (PageTriangle& triangle : triangles) std::ranges::sort(triangle);
  std::ranges::sort(triangles);
  triangles.erase(std::ranges::unique(triangles).begin(), triangles.end());
  return triangles;
}

// Returns the vertices that other pages have as well, and those whose triangles leave a gap: an
// edge of two triangles cancels at both ends, that of a rim does not.
std::vector<uint16_t> vertices_at_edges(const Page& page) {
  std::vector<uint64_t> uncancelled(page.positions.size(), 0);
  for (const PageTriangle& t : surface_of(page))
    for (int corner = 0; corner < 3; ++corner)
      uncancelled[t[corner]] ^= mixed(t[(corner + 1) % 3]) ^ mixed(t[(corner + 2) % 3]);
  std::vector<uint16_t> found;
  for (size_t vertex = 0; vertex < uncancelled.size(); ++vertex)
    if (vertex < page.border_vertices || uncancelled[vertex] != 0)
      found.push_back(static_cast<uint16_t>(vertex));
  return found;
}

}  // namespace

PageSize measure_page(const Page& page, int bits, int depth, bool has_rims) {
  const bool may_be_held = has_rims && !is_colours(page.id);
  return {static_cast<uint32_t>(page.positions.size()),
          static_cast<uint32_t>(page.triangles.size()),
          count_page_corners(page.positions, bits, depth),
          may_be_held ? static_cast<uint32_t>(vertices_at_edges(page).size()) : 0};
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

LivePage make_live_page(const Page& page, const PageSize& size, const PageGrid& lattice,
                        const SparseGrid& grid, PageFrameKind kind) {
  LivePage made;
  made.kind = kind;
  made.size = size;
  made.lattice = lattice;
  made.evaluation = make_page_evaluation(page, lattice.bits, grid, PageFrameKind::kVertices);
  made.cells = cells_of(made.evaluation);
  if (kind == PageFrameKind::kCorners)
    made.evaluation = make_page_evaluation(page, lattice.bits, grid, kind);
  else if (is_colours(page.id))
    made.colours = page.colours;
  if (size.edge_vertices == 0) return made;
  made.edge_vertices.reserve(size.edge_vertices);
  for (const uint16_t vertex : vertices_at_edges(page))
    made.edge_vertices.push_back({page.positions[vertex], vertex});
  return made;
}

}  // namespace burnish
