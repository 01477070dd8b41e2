#pragma once

#include <cstdint>
#include <span>

#include "common/grid/grid.h"
#include "common/grid/sparse_grid.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// One row of the evaluation matrix E (section 5.1). The eight trilinear weights follow from the
/// position of the vertex in its cell.
struct EvaluationPoint {
  int32_t cell = kNone;             ///< kNone: no surface is near, the vertex does not move
  std::array<float, 3> local = {};  ///< in [0, 1]³ of the cell
};
static_assert(sizeof(EvaluationPoint) == 16);

/// Makes E for the vertices of a mesh. A vertex on a grid plane takes an active cell that touches
/// it.
/// Shapes: one row per vertex; a vertex that no triangle references gets cell kNone. `cells` of the
/// frame's depth rise strictly.
void make_evaluation(const MeshView& mesh, const GridFrame& frame, std::span<const MortonKey> cells,
                     std::span<EvaluationPoint> points);

/// Returns the eight trilinear weights of a local position, in corner order.
std::array<float, kCornersPerCell> trilinear_weights(const std::array<float, 3>& local);

/// Returns Σ_I u_I B_I at a point. Shapes: one displacement per corner of the grid.
template <typename Displacement>
Displacement evaluate(const SparseGrid& grid, const EvaluationPoint& point,
                      std::span<const Displacement> corner_displacements) {
  Displacement sum = Displacement::Zero();
  if (point.cell == kNone) return sum;
  const auto weights = trilinear_weights(point.local);
  for (int a = 0; a < kCornersPerCell; ++a)
    sum += static_cast<typename Displacement::Scalar>(weights[a]) *
           corner_displacements[grid.cell_corners[point.cell][a]];
  return sum;
}

}  // namespace burnish
