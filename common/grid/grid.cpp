#include "common/grid/grid.h"

#include <algorithm>
#include <cmath>

#include "common/base/check.h"
#include "common/base/ratio.h"

namespace burnish {

static constexpr double kBoxFractionOfCube = 0.9;
static constexpr double kCellsPerMeanEdge = 1.5;
static constexpr double kSnapDistance = 1e-7;  // cells

static double longest_side(const Vec3d& box_min, const Vec3d& box_max) {
  return (box_max - box_min).maxCoeff();
}

GridFrame make_grid_frame(const Vec3d& box_min, const Vec3d& box_max, int depth) {
  BURNISH_CHECK(depth >= kDepthMin && depth <= kDepthMax, "depth is checked at the edge");
  const double side = longest_side(box_min, box_max) / kBoxFractionOfCube;
  BURNISH_CHECK(side > 0, "a mesh with area has a box");
  GridFrame frame;
  frame.depth = depth;
  frame.cell_size = side / frame.cells_per_side();
  frame.origin = (box_min + box_max) / 2 - Vec3d::Constant(side / 2);
  return frame;
}

int matching_depth(const Vec3d& box_min, const Vec3d& box_max, double mean_edge_length) {
  const double side = longest_side(box_min, box_max) / kBoxFractionOfCube;
  const double depth = std::round(binary_logarithm(side / (kCellsPerMeanEdge * mean_edge_length)));
  if (!(depth >= kDepthMin)) return kDepthMin;  // NaN too
  return static_cast<int>(std::min<double>(depth, kDepthMax));
}

Vec3d snap_to_planes(const Vec3d& grid_point) {
  const Vec3d plane = grid_point.array().round();
  return ((grid_point - plane).array().abs() < kSnapDistance).select(plane, grid_point);
}

}  // namespace burnish
