#pragma once

#include "common/base/types.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// The space in which pages are drawn: the grid's cube from -1 to 1. All steps and cells are powers
/// of two there, so that floats hold every lattice point exactly.
struct PageSpace {
  Vec3d centre = Vec3d::Zero();  ///< of the cube, file units
  double unit = 1;               ///< half a side of the cube, file units
  float cell_size = 0;           ///< in units

  Vec3d to_file(const Vec3f& point) const { return centre + unit * point.cast<double>(); }
  Vec3d to_file(const Vec3f& point, const Vec3f& displacement) const {
    return to_file(point) + unit * cell_size * displacement.cast<double>();
  }
};

/// `depth` is the session's: displacements are in its cells.
inline PageSpace make_page_space(const PageGrid& grid, int depth) {
  const double half = grid.side / 2;
  return {grid.origin + Vec3d::Constant(half), half, std::ldexp(2.0f, -depth)};
}

}  // namespace burnish
