#pragma once

#include <vector>

#include <Eigen/Core>

namespace burnish {

/// A cut of a V-shaped chisel along a segment; a drilled pit where both ends are the same.
/// Millimetres, in the plane of the tablet's face.
struct Groove {
  Eigen::Vector2d from, to;
  double half_width;
  double depth;
};

/// The floor plan on the tablet, after the marble plan of ancient Rome: a street with a row of
/// shops, a courtyard with columns and its name, a hall with an apse, stairs. It reaches beyond any
/// fragment's outline, so that the fracture cuts through it.
std::vector<Groove> tablet_plan();

/// How deep the grooves are cut at p: the deepest of those that reach it, 0 between them.
double groove_depth(const std::vector<Groove>& grooves, const Eigen::Vector2d& p);

}  // namespace burnish
