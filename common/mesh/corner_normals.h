#pragma once

#include <array>

#include "common/base/types.h"

namespace burnish {

/// Returns at each corner of a triangle its unit normal times the sine of the corner's angle. The
/// sum of those of its triangles is a vertex's normal. The sine, unlike the angle, makes little of
/// a needle whose one angle is nearly flat: rounding may turn such a triangle over. A triangle with
/// an edge of no length has none.
inline std::array<Vec3d, 3> corner_normals(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d ab = (b - a).stableNormalized(), bc = (c - b).stableNormalized(),
              ca = (a - c).stableNormalized();
  return {ca.cross(ab), ab.cross(bc), bc.cross(ca)};
}

}  // namespace burnish
