#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/base/limits.h"
#include "common/base/types.h"

namespace burnish {

/// The place of the 2^depth grid: a cube centred on the bounding box of the referenced vertices.
/// The longest side of the box is 0.9 of the cube's side. Grid units: cell edge 1, planes at
/// integers.
struct GridFrame {
  Vec3d origin = Vec3d::Zero();  ///< file units: the cube's least corner
  double cell_size = 1;          ///< file units
  int depth = kDepthMin;

  int cells_per_side() const { return 1 << depth; }
  Vec3d to_grid(const Vec3d& p) const { return (p - origin) / cell_size; }
  Vec3d to_file(const Vec3d& g) const { return origin + g * cell_size; }
};

/// Needs: box_max > box_min in at least one axis, kDepthMin <= depth <= kDepthMax.
GridFrame make_grid_frame(const Vec3d& box_min, const Vec3d& box_max, int depth);

/// Returns the depth at which a cell is about 1.5 mean edges, within kDepthMin..kDepthMax.
int matching_depth(const Vec3d& box_min, const Vec3d& box_max, double mean_edge_length);

/// Rounds coordinates that are within 1e-7 of a grid plane onto it, so that clipping and evaluation
/// agree on which side of the plane a vertex lies.
Vec3d snap_to_planes(const Vec3d& grid_point);

}  // namespace burnish
