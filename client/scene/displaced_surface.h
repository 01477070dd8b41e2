#pragma once

#include <optional>
#include <span>

#include "client/scene/camera.h"
#include "client/scene/view_mesh.h"

namespace burnish {

/// A mesh as it lies now. Nothing is copied.
struct DisplacedSurface {
  const ViewMesh& mesh;
  std::span<const Vec3f> displacements;  ///< one per corner, cells; empty: nothing moved
};

/// Where a ray meets the surface.
struct SurfaceHit {
  uint32_t triangle = 0;
  Vec3d weights = Vec3d::Zero();    ///< barycentric, not negative, sum 1
  Vec3d displaced = Vec3d::Zero();  ///< file units, where it is now
  Vec3d original = Vec3d::Zero();   ///< file units, the same point of the surface before all edits
  double distance = 0;              ///< from the ray's origin, file units
};

/// File units.
Vec3d original_vertex(const ViewMesh& mesh, uint32_t vertex);
Vec3d displaced_vertex(const DisplacedSurface& surface, uint32_t vertex);

/// The point of this triangle that the ray meets, or passes nearest in the triangle's plane: a
/// triangle that a picture shows at a pixel may miss the pixel's ray by a rounding.
/// Nothing where the ray runs along the plane or away from it.
std::optional<SurfaceHit> point_on_triangle(const DisplacedSurface& surface, const Ray& ray,
                                            uint32_t triangle);

/// Where the ray meets the surface first. Cost: O(triangles).
std::optional<SurfaceHit> nearest_hit(const DisplacedSurface& surface, const Ray& ray);

}  // namespace burnish
