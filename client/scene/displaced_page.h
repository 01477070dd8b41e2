#pragma once

#include <optional>
#include <span>

#include "client/scene/page_mesh.h"
#include "client/scene/page_space.h"
#include "client/scene/surface_hit.h"

namespace burnish {

/// A displaced page. Nothing is copied.
struct DisplacedPage {
  const PageMesh& mesh;
  const PageSpace& space;
  std::span<const Vec3f> displacements;  ///< one per vertex, cells; empty: nothing moved
};

/// Returns the position in file units.
Vec3d displaced_position(const DisplacedPage& page, size_t vertex);

/// Returns the first point where the ray meets these triangles. Cost: O(count).
std::optional<SurfaceHit> nearest_hit(const DisplacedPage& page, const Ray& ray, uint32_t first,
                                      uint32_t count);

}  // namespace burnish
