#include "common/page_frames/page_evaluation.h"

#include <algorithm>

#include "common/page_frames/page_corners.h"

namespace burnish {

namespace {

constexpr float kTouchDistance = 1e-6F;  // cells

/// Says along one axis whether a point touches the cell below or the one above.
int touching_step(float local, float tolerance) {
  if (local <= tolerance) return -1;
  return 1 - local <= tolerance ? 1 : 0;
}

EvaluationPoint point_in(int32_t cell, const CellPlace& place, const Vec3i& step) {
  EvaluationPoint point{cell, place.local};
  for (int axis = 0; axis < 3; ++axis)
    if (step[axis] != 0) point.local[axis] = step[axis] < 0 ? 1.F : 0.F;
  return point;
}

// Tries the vertex's own cell first, then those that it touches.
EvaluationPoint locate_vertex(const Vec3i& position, int bits, const SparseGrid& grid) {
  const CellPlace place = cell_place(position, bits, grid.depth);
  const float half_step = 0.5F / static_cast<float>(1 << (bits - grid.depth));
  Vec3i touching;
  for (int axis = 0; axis < 3; ++axis)
    touching[axis] = touching_step(place.local[axis], std::max(half_step, kTouchDistance));
  for (int a = 0; a < kCornersPerCell; ++a) {
    const Vec3i step = touching.cwiseProduct(corner_offset(a));
    const int32_t cell = grid.find_cell(place.cell + step);
    if (cell != kNone) return point_in(cell, place, step);
  }
  return {};
}

int32_t find_corner(const SparseGrid& grid, const Vec3i& corner) {
  if (corner.minCoeff() < 0) return kNone;
  const MortonKey place = morton_key(corner);
  const auto at = std::ranges::lower_bound(grid.corners, place, {}, &GridKey::place);
  if (at == grid.corners.end() || at->place != place) return kNone;
  return static_cast<int32_t>(at - grid.corners.begin());
}

// A point at a corner has weight 1 there, and 0 elsewhere.
EvaluationPoint point_at(const SparseGrid& grid, int32_t corner) {
  for (int a = 0; a < kCornersPerCell; ++a) {
    const int32_t cell = grid.cells_of_corner[corner][a];
    if (cell == kNone) continue;
    const Vec3f local = corner_offset(a).cast<float>();
    return {cell, {local.x(), local.y(), local.z()}};
  }
  return {};
}

EvaluationPoint locate_corner(MortonKey place, const SparseGrid& grid) {
  const Vec3i corner = morton_point(place);
  int32_t found = find_corner(grid, corner);
  for (int axis = 0; axis < 3 && found == kNone; ++axis) {
    found = find_corner(grid, corner - Vec3i::Unit(axis));
    if (found == kNone) found = find_corner(grid, corner + Vec3i::Unit(axis));
  }
  return found == kNone ? EvaluationPoint{} : point_at(grid, found);
}

}  // namespace

PageEvaluation make_page_evaluation(const Page& page, int bits, const SparseGrid& grid,
                                    PageFrameKind kind) {
  PageEvaluation evaluation;
  if (kind == PageFrameKind::kVertices) {
    evaluation.shown = {page.id, std::make_shared<const PageLayout>(make_vertex_page_layout(page))};
    evaluation.points.reserve(page.positions.size());
    for (const Vec3i& position : page.positions)
      evaluation.points.push_back(locate_vertex(position, bits, grid));
    return evaluation;
  }
  const PageCorners corners = make_page_corners(page.positions, bits, grid.depth);
  evaluation.shown = {page.id,
                      std::make_shared<const PageLayout>(make_corner_page_layout(corners))};
  evaluation.points.reserve(corners.places.size());
  for (const MortonKey place : corners.places)
    evaluation.points.push_back(locate_corner(place, grid));
  return evaluation;
}

}  // namespace burnish
