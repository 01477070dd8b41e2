#pragma once

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// A plane with axes of its own. The same plane always has the same axes.
struct Plane {
  Vec3d point = Vec3d::Zero();    ///< file units; the origin of the axes
  Vec3d normal = Vec3d::UnitZ();  ///< of length 1

  double height_of(const Vec3d& at) const { return normal.dot(at - point); }
};

/// Two unit vectors at right angles in the plane. `up` is as near to the y axis as the plane
/// allows, or to the z axis where the plane is level.
struct PlaneAxes {
  Vec3d right;
  Vec3d up;
};

PlaneAxes axes_of(const Plane& plane);

/// Returns the plane through a point across a direction of any length. Fails: invalid_argument for
/// values that are not finite or above kCoordinateMagnitudeMax, and for a direction of length 0.
Result<Plane> make_plane(const Vec3d& point, const Vec3d& direction);

}  // namespace burnish
