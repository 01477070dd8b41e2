#include "common/evaluation/evaluation.h"

#include <algorithm>
#include <cmath>

namespace burnish {

static constexpr double kTouchDistance = 1e-6;  // cells

static std::vector<bool> referenced_vertices(const TriangleMesh& mesh) {
  std::vector<bool> referenced(mesh.vertices.size(), false);
  for (const Triangle& triangle : mesh.triangles)
    for (uint32_t v : triangle) referenced[v] = true;
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
static EvaluationPoint locate(const Vec3d& p, const SparseGrid& grid) {
  const Vec3i home = p.array().floor().cast<int>();
  for (int mask = 0; mask < 8; ++mask) {
    for (int sign = -1; sign <= 1; sign += 2) {
      const Vec3i step = sign * corner_offset(mask);
      const Vec3i cell = home + step;
      const Vec3d outside =
          (cell.cast<double>() - p).cwiseMax(p - cell.cast<double>() - Vec3d::Ones());
      if (outside.maxCoeff() > kTouchDistance) continue;
      const int32_t index = grid.find_cell(cell);
      if (index != kNone) return point_in_cell(p, cell, index);
    }
  }
  return {};
}

std::vector<EvaluationPoint> make_evaluation(const TriangleMesh& mesh, const GridFrame& frame,
                                             const SparseGrid& grid) {
  const std::vector<bool> referenced = referenced_vertices(mesh);
  std::vector<EvaluationPoint> points(mesh.vertices.size());
#pragma omp parallel for schedule(static)
  for (int64_t v = 0; v < static_cast<int64_t>(points.size()); ++v) {
    if (referenced[v]) points[v] = locate(snap_to_planes(frame.to_grid(mesh.vertices[v])), grid);
  }
  return points;
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
