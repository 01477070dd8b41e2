#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/mesh/rewrite/moved/moved_normals.h"

namespace burnish {

inline constexpr uint32_t kNoPlace = UINT32_MAX;

/// The positions of a mesh, each counted once: vertices of a seam stand at one place.
struct Places {
  std::vector<uint32_t> of_vertex;
  uint32_t count = 0;
  bool are_shared() const { return count < of_vertex.size(); }
};
Places find_places(std::span<const Vec3d> positions);

/// Lets normals that were equal at one place share the triangles around them, so that they stay
/// equal. Others keep their crease. `places` has a place for each normal, or kNoPlace.
void share_areas(std::span<const uint32_t> places, std::span<const Vec3f> normals,
                 std::span<AreaVectors> areas);

}  // namespace burnish
