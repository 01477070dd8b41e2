#pragma once

#include <algorithm>
#include <cmath>

#include "common/base/limits.h"
#include "common/base/types.h"

namespace burnish {

/// The lattice of a scan's page positions: the grid's cube, which is the same at all depths, in
/// 2^bits steps a side. A position is three steps and means the middle of its step.
struct PageGrid {
  Vec3d origin = Vec3d::Zero();  ///< file units: the cube's least corner
  double side = 1;               ///< file units
  int bits = kPageGridBitsMax;

  int steps() const { return 1 << bits; }
  double step() const { return side / steps(); }

  /// Rounds down, so that `q >> (bits - depth)` is the cell at a depth that holds the point. Takes
  /// the nearest step for a point outside the cube.
  Vec3i quantise(const Vec3d& point) const {
    Vec3i position;
    for (int axis = 0; axis < 3; ++axis) {
      const double place = std::floor((point[axis] - origin[axis]) / side * steps());
      position[axis] = static_cast<int>(std::clamp(place, 0.0, steps() - 1.0));
    }
    return position;
  }
  bool operator==(const PageGrid&) const = default;
  Vec3d to_file(const Vec3i& position) const {
    return origin + (position.cast<double>() + Vec3d::Constant(0.5)) * step();
  }
};

}  // namespace burnish
