#include "client/scene/surface_hit.h"

namespace burnish {

static constexpr double kTouch = 1e-9;  // barycentric

std::optional<PlaneHit> hit_plane(const std::array<Vec3d, 3>& corners, const Ray& ray) {
  // After Möller and Trumbore, by volumes of the ray with the edges.
  const Vec3d u = corners[1] - corners[0], v = corners[2] - corners[0];
  const Vec3d across = ray.direction.cross(v);
  const double volume = u.dot(across);
  if (volume == 0) return std::nullopt;
  const Vec3d from = ray.origin - corners[0];
  const Vec3d around = from.cross(u);
  const double b = from.dot(across) / volume, c = ray.direction.dot(around) / volume;
  const double distance = v.dot(around) / volume;
  if (!(distance > 0)) return std::nullopt;
  return PlaneHit{Vec3d(1 - b - c, b, c), distance};
}

bool is_inside(const PlaneHit& plane) {
  return plane.weights.minCoeff() >= -kTouch;
}

SurfaceHit make_hit(const TriangleCorners& corners, uint32_t triangle, const PlaneHit& plane) {
  SurfaceHit hit{triangle, plane.weights.cwiseMax(0)};
  hit.weights /= hit.weights.sum();
  hit.distance = plane.distance;
  for (int i = 0; i < 3; ++i) {
    hit.displaced += hit.weights[i] * corners.displaced[i];
    hit.original += hit.weights[i] * corners.original[i];
  }
  const auto& [a, b, c] = corners.original;
  hit.normal = (b - a).cross(c - a).stableNormalized();
  return hit;
}

}  // namespace burnish
