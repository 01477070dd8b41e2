#include "common/evaluation/evaluation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/evaluation/heard_evaluation.h"

namespace burnish {

static constexpr double kTouchDistance = 1e-6;  // cells

namespace {

struct FinestCells {
  int depth;
  std::span<const MortonKey> keys;  // strictly rising

  int32_t find(const Vec3i& cell) const {
    const int side = 1 << depth;
    if ((cell.array() < 0).any() || (cell.array() >= side).any()) return kNone;
    const MortonKey key = morton_key(cell);
    const auto at = std::ranges::lower_bound(keys, key);
    return at != keys.end() && *at == key ? static_cast<int32_t>(at - keys.begin()) : kNone;
  }
};

}  // namespace

static std::vector<bool> referenced_vertices(const MeshView& mesh, const LoopPart& part) {
  std::vector<bool> referenced(mesh.vertices.size(), false);
  for_each_heard(part, mesh.triangles.size(), [&](size_t t) {
    for (uint32_t v : mesh.triangles[t]) referenced[v] = true;
  });
  return referenced;
}

static EvaluationPoint point_in_cell(const Vec3d& p, const Vec3i& cell, int32_t index) {
  EvaluationPoint point;
  point.cell = index;
  for (int axis = 0; axis < 3; ++axis)
    point.local[axis] = static_cast<float>(std::clamp(p[axis] - cell[axis], 0.0, 1.0));
  return point;
}

// Finds the active cell that holds or touches the point; tries the cell above each plane first. The
// surface is continuous across cells, so each of them gives the same value.
static EvaluationPoint locate(const Vec3d& p, const FinestCells& cells) {
  const Vec3i home = p.array().floor().cast<int>();
  for (int mask = 0; mask < 8; ++mask) {
    for (int sign = -1; sign <= 1; sign += 2) {
      const Vec3i step = sign * corner_offset(mask);
      const Vec3i cell = home + step;
      const Vec3d outside =
          (cell.cast<double>() - p).cwiseMax(p - cell.cast<double>() - Vec3d::Ones());
      if (outside.maxCoeff() > kTouchDistance) continue;
      const int32_t index = cells.find(cell);
      if (index != kNone) return point_in_cell(p, cell, index);
    }
  }
  return {};
}

void make_evaluation(const MeshView& mesh, const GridFrame& frame, std::span<const MortonKey> cells,
                     std::span<EvaluationPoint> points, const LoopPart& part) {
  const std::vector<bool> referenced = referenced_vertices(mesh, part.of(0, 0.2));
  const FinestCells finest{frame.depth, cells};
  parallel_for_heard(part.of(0.2, 1), points.size(), [&](size_t v) {
    points[v] = {};
    if (referenced[v]) points[v] = locate(snap_to_planes(frame.to_grid(mesh.vertices[v])), finest);
  });
}

void make_evaluation(const MeshView& mesh, const GridFrame& frame, std::span<const MortonKey> cells,
                     std::span<EvaluationPoint> points) {
  make_evaluation(mesh, frame, cells, points, kUnheardLoop);
}

std::array<float, kCornersPerCell> trilinear_weights(const std::array<float, 3>& local) {
  std::array<float, kCornersPerCell> weights;
  for (int a = 0; a < kCornersPerCell; ++a) {
    float w = 1;
    for (int axis = 0; axis < 3; ++axis) w *= (a >> axis & 1) ? local[axis] : 1 - local[axis];
    weights[a] = w;
  }
  return weights;
}

}  // namespace burnish
