#pragma once

#include <optional>
#include <span>

#include "client/scene/surface_hit.h"
#include "client/scene/view_mesh.h"

namespace burnish {

/// A displaced mesh. Nothing is copied.
struct DisplacedSurface {
  const ViewMesh& mesh;
  std::span<const Vec3f> displacements;  ///< one per corner, cells; empty: nothing moved
};

/// Returns the position in file units.
Vec3d original_vertex(const ViewMesh& mesh, uint32_t vertex);
Vec3d displaced_vertex(const DisplacedSurface& surface, uint32_t vertex);

/// Returns the point of this triangle that the ray meets, or the nearest point to it in the
/// triangle's plane: by rounding, the ray of a pixel may miss the triangle that the picture shows
/// there. Returns nothing if the ray runs along the plane or away from it.
std::optional<SurfaceHit> point_on_triangle(const DisplacedSurface& surface, const Ray& ray,
                                            uint32_t triangle);

/// Returns the first point where the ray meets the surface. Cost: O(triangles).
std::optional<SurfaceHit> nearest_hit(const DisplacedSurface& surface, const Ray& ray);

}  // namespace burnish
