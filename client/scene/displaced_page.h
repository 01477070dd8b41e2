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

/// Does what point_on_triangle() does, for a triangle of a page.
std::optional<SurfaceHit> point_on_page_triangle(const DisplacedPage& page, const Ray& ray,
                                                 uint32_t triangle);

/// Returns the first point where the ray meets these triangles. Cost: O(count).
std::optional<SurfaceHit> nearest_hit(const DisplacedPage& page, const Ray& ray, uint32_t first,
                                      uint32_t count);

}  // namespace burnish
