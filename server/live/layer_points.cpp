#include "server/live/layer_points.h"

#include <cmath>
#include <utility>

namespace burnish {

LayerPoints::LayerPoints(const SparseGrid& grid, std::span<const EvaluationPoint> scan)
    : grid_(grid), scan_(scan), first_(grid.cells.size() + 1, 0) {
  for (const EvaluationPoint& point : scan)
    if (point.cell != kNone) ++first_[point.cell + 1];
  for (size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  vertices_.resize(first_.back());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (size_t v = 0; v < scan.size(); ++v)
    if (scan[v].cell != kNone) vertices_[next[scan[v].cell]++] = static_cast<uint32_t>(v);
}

LayerPoints::OfPage LayerPoints::of(const std::shared_ptr<const LivePage>& page) {
  const auto known = found_.find(page.get());
  if (known != found_.end() && !known->second.page.expired()) return known->second.of_scan;
  std::erase_if(found_, [](const auto& entry) { return entry.second.page.expired(); });
  return found_.insert_or_assign(page.get(), Found{page, find(*page)}).first->second.of_scan;
}

LayerPoints::OfPage LayerPoints::find(const LivePage& page) const {
  const auto half_step =
      static_cast<float>(std::ldexp(0.5, grid_.depth - page.lattice.bits));  // cells
  const std::vector<EvaluationPoint>& points = page.evaluation.points;
  auto found = std::make_shared<std::vector<uint32_t>>(points.size());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < points.size(); ++v) (*found)[v] = find(points[v], half_step);
  return found;
}

// A vertex of the scan is within half a step along each axis. One on a plane between cells may be
// in another cell than the page says.
uint32_t LayerPoints::find(const EvaluationPoint& point, float half_step) const {
  if (point.cell == kNone) return kNoVertex;
  const Vec3f place(point.local.data());
  const float near = 1.01F * half_step;
  Nearest nearest;
  look_in(point.cell, place, nearest);
  if (nearest.distance <= 3 * near * near) return nearest.vertex;
  for (const int32_t corner : grid_.cell_corners[point.cell])
    for (const int32_t cell : grid_.cells_of_corner[corner])
      if (cell != kNone && cell != point.cell) look_in(cell, place_of(point, cell), nearest);
  return nearest.vertex;
}

// Vertices at one place move alike, so any of them will do.
void LayerPoints::look_in(int32_t cell, const Vec3f& place, Nearest& nearest) const {
  for (uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
    const uint32_t vertex = vertices_[i];
    const float distance = (Vec3f(scan_[vertex].local.data()) - place).squaredNorm();
    if (distance < nearest.distance) nearest = {vertex, distance};
  }
}

// Returns a point's place in the coordinates of another cell.
Vec3f LayerPoints::place_of(const EvaluationPoint& point, int32_t seen_from) const {
  const Vec3i from = morton_point(grid_.cells[point.cell].place);
  const Vec3i to = morton_point(grid_.cells[seen_from].place);
  return Vec3f(point.local.data()) + (from - to).cast<float>();
}

}  // namespace burnish
