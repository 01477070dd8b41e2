#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "client/scene/camera.h"

namespace burnish {

/// A point where a ray meets the surface.
struct SurfaceHit {
  uint32_t triangle = 0;
  Vec3d weights = Vec3d::Zero();    ///< barycentric, not negative, sum 1
  Vec3d displaced = Vec3d::Zero();  ///< file units, displaced
  Vec3d original = Vec3d::Zero();   ///< file units, the same point before all edits
  double distance = 0;              ///< from the ray's origin, file units
  Vec3d normal = Vec3d::Zero();     ///< of the triangle before all edits, length 1
  double mark = 0;                  ///< as VertexMark::value, between the vertices; 0 without marks

  /// The move along the normal, file units; outwards is positive.
  double moved() const { return normal.dot(displaced - original); }
};

/// The vertices of a triangle, file units.
struct TriangleCorners {
  std::array<Vec3d, 3> displaced;
  std::array<Vec3d, 3> original;
};

/// A point where a ray meets the plane of a triangle.
struct PlaneHit {
  Vec3d weights;    ///< barycentric, of any sign, sum 1
  double distance;  ///< from the ray's origin, file units
};

/// Returns nothing if the ray runs along the plane or away from it.
std::optional<PlaneHit> hit_plane(const std::array<Vec3d, 3>& corners, const Ray& ray);

/// Returns whether the point lies in the triangle. A point within rounding of an edge lies in the
/// triangles of both sides, so that no ray passes between them.
bool is_inside(const PlaneHit& plane);

/// Returns the point of the plane if it lies in the triangle, else the nearest by weights.
SurfaceHit make_hit(const TriangleCorners& corners, uint32_t triangle, const PlaneHit& plane);

}  // namespace burnish
