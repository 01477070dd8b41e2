#pragma once

#include <string_view>

#include "common/base/status.h"
#include "common/edit/brush.h"

namespace burnish {

/// A plane across an axis of the scan. Strokes are painted on both of its sides.
struct MirrorPlane {
  int axis = 0;   ///< 0, 1, 2: x, y, z
  double at = 0;  ///< where it cuts the axis, file units

  bool operator==(const MirrorPlane&) const = default;
};

/// Returns the point on the plane's other side.
Vec3d mirrored(Vec3d point, const MirrorPlane& plane);

/// Returns the stroke on the plane's other side, with the same brush.
Stroke mirrored(Stroke stroke, const MirrorPlane& plane);

/// Fails: invalid_argument for a name that is not x, y or z.
Result<int> parse_axis(std::string_view name);

}  // namespace burnish
