#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "common/base/types.h"

namespace burnish {

/// A mesh in the grid of one depth. The arrays belong to the caller.
struct GridMesh {
  std::span<const Triangle> triangles;
  std::span<const Vec3d> positions;  ///< one per vertex, snapped to planes; grid units
  int depth = 0;

  std::array<Vec3d, 3> corners(uint32_t triangle) const {
    const Triangle& t = triangles[triangle];
    return {positions[t[0]], positions[t[1]], positions[t[2]]};
  }
};

}  // namespace burnish
