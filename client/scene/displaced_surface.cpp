#include "client/scene/displaced_surface.h"

#include "common/evaluation/evaluation.h"

namespace burnish {

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

static std::array<Vec3d, 3> displaced_corners(const DisplacedSurface& surface, uint32_t triangle) {
  std::array<Vec3d, 3> corners;
  for (int i = 0; i < 3; ++i)
    corners[i] = displaced_vertex(surface, surface.mesh.triangles[triangle][i]);
  return corners;
}

static TriangleCorners corners_of(const DisplacedSurface& surface, uint32_t triangle) {
  TriangleCorners corners{displaced_corners(surface, triangle), {}};
  for (int i = 0; i < 3; ++i)
    corners.original[i] = original_vertex(surface.mesh, surface.mesh.triangles[triangle][i]);
  return corners;
}

std::optional<SurfaceHit> point_on_triangle(const DisplacedSurface& surface, const Ray& ray,
                                            uint32_t triangle) {
  const TriangleCorners corners = corners_of(surface, triangle);
  const auto plane = hit_plane(corners.displaced, ray);
  if (!plane) return std::nullopt;
  return make_hit(corners, triangle, *plane);
}

std::optional<SurfaceHit> nearest_hit(const DisplacedSurface& surface, const Ray& ray) {
  std::optional<PlaneHit> nearest;
  uint32_t nearest_triangle = 0;
  for (uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const auto plane = hit_plane(displaced_corners(surface, t), ray);
    if (!plane || !is_inside(*plane)) continue;
    if (nearest && nearest->distance <= plane->distance) continue;
    nearest = plane;
    nearest_triangle = t;
  }
  if (!nearest) return std::nullopt;
  return make_hit(corners_of(surface, nearest_triangle), nearest_triangle, *nearest);
}

}  // namespace burnish
