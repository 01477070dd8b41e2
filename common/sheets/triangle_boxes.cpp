#include "common/sheets/triangle_boxes.h"

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

constexpr double kTrianglesPerCell = 4;  // of a surface: cells go with the square of a side
constexpr int kCellsPerSideMax = 32;

Box3d box_of(const std::array<Vec3d, 3>& corners) {
  Box3d box;
  for (const Vec3d& corner : corners) box.extend(corner);
  return box;
}

}  // namespace

TriangleBoxes::TriangleBoxes(std::span<const std::array<Vec3d, 3>> triangles) {
  for (const auto& corners : triangles) all_.extend(box_of(corners));
  if (triangles.empty()) return;
  const double per_side = std::sqrt(static_cast<double>(triangles.size()) / kTrianglesPerCell);
  const double longest = all_.sizes().maxCoeff();
  for (int axis = 0; axis < 3 && longest > 0; ++axis)
    cells_[axis] =
        std::clamp(static_cast<int>(per_side * all_.sizes()[axis] / longest), 1, kCellsPerSideMax);
  triangles_ = group_by<uint32_t, uint32_t>(
      static_cast<size_t>(cells_[0]) * cells_[1] * cells_[2], [&](const auto& add) {
        for (uint32_t t = 0; t < triangles.size(); ++t)
          for_each_cell(box_of(triangles[t]), [&](size_t cell) { add(cell, t); });
      });
}

std::vector<uint32_t> TriangleBoxes::near(const Box3d& box) const {
  std::vector<uint32_t> found;
  if (all_.isEmpty() || !all_.intersects(box)) return found;
  for_each_cell(box, [&](size_t cell) {
    const auto in_cell = triangles_[cell];
    found.insert(found.end(), in_cell.begin(), in_cell.end());
  });
  std::ranges::sort(found);
  const auto rest = std::ranges::unique(found);
  found.erase(rest.begin(), rest.end());
  return found;
}

TriangleBoxes::Cell TriangleBoxes::cell_of(const Vec3d& place) const {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = all_.sizes()[axis];
    const double part = size > 0 ? (place[axis] - all_.min()[axis]) / size : 0;
    cell[axis] =
        static_cast<int>(std::clamp(std::floor(part * cells_[axis]), 0.0, cells_[axis] - 1.0));
  }
  return cell;
}

template <typename Visit>
void TriangleBoxes::for_each_cell(const Box3d& box, const Visit& visit) const {
  const Cell first = cell_of(box.min());
  const Cell last = cell_of(box.max());
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int x = first[0]; x <= last[0]; ++x)
        visit((static_cast<size_t>(z) * cells_[1] + y) * cells_[0] + x);
}

}  // namespace burnish
