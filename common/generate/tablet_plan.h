#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace burnish {

/// A cut of a V-shaped chisel along a segment; a drilled pit if both ends are the same. Units:
/// millimetres, in the plane of the tablet's face.
struct Groove {
  Eigen::Vector2d from, to;
  double half_width;
  double depth;
};

/// The floor plan on the tablet, after the marble plan of ancient Rome: a street with a row of
/// shops, a courtyard with columns and its name, a hall with an apse, stairs. The plan reaches
/// beyond the outline of every fragment, so that the fracture cuts through it.
std::vector<Groove> tablet_plan();

/// Returns the region of the courtyard's name. No other groove reaches into it.
Eigen::AlignedBox2d inscription_box();

/// Returns how deep the stone is cut at p: by the deepest groove there, 0 between grooves.
double groove_depth(const std::vector<Groove>& grooves, const Eigen::Vector2d& p);

}  // namespace burnish
