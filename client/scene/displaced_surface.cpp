#include "client/scene/displaced_surface.h"

#include <array>

#include "common/evaluation/evaluation.h"

namespace burnish {

static constexpr double kTouch = 1e-9;  // barycentric; a ray through an edge misses neither side

Vec3d original_vertex(const ViewMesh& mesh, uint32_t vertex) {
  return mesh.box.center() + mesh.unit() * mesh.positions[vertex].cast<double>();
}

Vec3d displaced_vertex(const DisplacedSurface& surface, uint32_t vertex) {
  const ViewMesh& mesh = surface.mesh;
  const Vec3d original = original_vertex(mesh, vertex);
  if (surface.displacements.empty() || mesh.points[vertex].cell == kNone) return original;
  const EvaluationPoint& point = mesh.points[vertex];
  const auto weights = trilinear_weights(point.local);
  Vec3f moved = Vec3f::Zero();
  for (int a = 0; a < kCornersPerCell; ++a)
    moved += weights[a] * surface.displacements[mesh.cell_corners[point.cell][a]];
  return original + mesh.cell_size * mesh.unit() * moved.cast<double>();
}

namespace {

struct Corners {
  std::array<Vec3d, 3> at;
};

Corners displaced_corners(const DisplacedSurface& surface, uint32_t triangle) {
  Corners corners;
  for (int i = 0; i < 3; ++i)
    corners.at[i] = displaced_vertex(surface, surface.mesh.triangles[triangle][i]);
  return corners;
}

struct PlaneHit {
  Vec3d weights;  // barycentric, of any sign
  double distance;
};

// Intersects after Möller and Trumbore, by volumes of the ray with the edges.
std::optional<PlaneHit> hit_plane(const Corners& corners, const Ray& ray) {
  const Vec3d u = corners.at[1] - corners.at[0], v = corners.at[2] - corners.at[0];
  const Vec3d across = ray.direction.cross(v);
  const double volume = u.dot(across);
  if (volume == 0) return std::nullopt;
  const Vec3d from = ray.origin - corners.at[0];
  const Vec3d around = from.cross(u);
  const double b = from.dot(across) / volume, c = ray.direction.dot(around) / volume;
  const double distance = v.dot(around) / volume;
  if (!(distance > 0)) return std::nullopt;
  return PlaneHit{Vec3d(1 - b - c, b, c), distance};
}

SurfaceHit make_hit(const DisplacedSurface& surface, const Corners& corners, uint32_t triangle,
                    const PlaneHit& plane) {
  SurfaceHit hit{triangle, plane.weights.cwiseMax(0)};
  hit.weights /= hit.weights.sum();
  hit.distance = plane.distance;
  for (int i = 0; i < 3; ++i) {
    const uint32_t vertex = surface.mesh.triangles[triangle][i];
    hit.displaced += hit.weights[i] * corners.at[i];
    hit.original += hit.weights[i] * original_vertex(surface.mesh, vertex);
  }
  return hit;
}

}  // namespace

std::optional<SurfaceHit> point_on_triangle(const DisplacedSurface& surface, const Ray& ray,
                                            uint32_t triangle) {
  const Corners corners = displaced_corners(surface, triangle);
  const auto plane = hit_plane(corners, ray);
  if (!plane) return std::nullopt;
  return make_hit(surface, corners, triangle, *plane);
}

std::optional<SurfaceHit> nearest_hit(const DisplacedSurface& surface, const Ray& ray) {
  std::optional<PlaneHit> nearest;
  uint32_t nearest_triangle = 0;
  for (uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const auto plane = hit_plane(displaced_corners(surface, t), ray);
    if (!plane || plane->weights.minCoeff() < -kTouch) continue;
    if (nearest && nearest->distance <= plane->distance) continue;
    nearest = plane;
    nearest_triangle = t;
  }
  if (!nearest) return std::nullopt;
  return make_hit(surface, displaced_corners(surface, nearest_triangle), nearest_triangle,
                  *nearest);
}

}  // namespace burnish
