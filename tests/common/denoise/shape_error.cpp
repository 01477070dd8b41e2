#include "tests/common/denoise/shape_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/denoise/welded_surface.h"
#include "common/mesh/statistics/statistics.h"

namespace burnish {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

Vec3d doubled_area_of(const TriangleMesh& mesh, size_t t) {
  const auto [a, b, c] = corners_of(mesh, t);
  return (b - a).cross(c - a);
}

double mean_angle(const TriangleMesh& clean, const TriangleMesh& mesh) {
  double sum = 0, area = 0;
  for (size_t t = 0; t < clean.triangles.size(); ++t) {
    const Vec3d n = doubled_area_of(clean, t), m = doubled_area_of(mesh, t);
    sum += n.norm() * std::atan2(n.cross(m).norm(), n.dot(m));
    area += n.norm();
  }
  return sum / area * kDegrees;
}

double signed_volume_of(const TriangleMesh& mesh) {
  const Vec3d origin = mesh.vertices[mesh.triangles[0][0]];
  double six = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = corners_of(mesh, t);
    six += (a - origin).dot((b - origin).cross(c - origin));
  }
  return six / 6;
}

double distance_to_side(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (p - a - t * along).norm();
}

/// Returns the distance of p from a triangle of the clean mesh.
double distance_to_triangle(const Vec3d& p, const TriangleMesh& mesh, size_t t) {
  const auto corners = corners_of(mesh, t);
  const Vec3d normal = doubled_area_of(mesh, t).normalized();
  bool is_above = normal.squaredNorm() > 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3d &a = corners[i], &b = corners[(i + 1) % 3];
    is_above = is_above && normal.dot((b - a).cross(p - a)) >= 0;
    nearest = std::min(nearest, distance_to_side(p, a, b));
  }
  return is_above ? std::abs(normal.dot(p - corners[0])) : nearest;
}

double distance_around(const WeldedSurface& clean, const TriangleMesh& clean_mesh, size_t place,
                       const Vec3d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const uint32_t t : clean.fan(place))
    for (const uint32_t corner : clean.triangle(t))
      for (const uint32_t near : clean.fan(corner))
        nearest = std::min(nearest, distance_to_triangle(p, clean_mesh, near));
  return nearest;
}

double rms_distance(const TriangleMesh& clean, const TriangleMesh& mesh) {
  const WeldedSurface surface(clean);
  double squares = 0, count = 0;
  for (size_t v = 0; v < clean.vertices.size(); ++v) {
    if (surface.fan(v).empty()) continue;
    const double distance = distance_around(surface, clean, v, mesh.vertices[v]);
    squares += distance * distance;
    ++count;
  }
  return std::sqrt(squares / count) / compute_statistics(clean).mean_edge_length;
}

}  // namespace

ShapeError shape_error(const TriangleMesh& clean, const TriangleMesh& mesh) {
  return {mean_angle(clean, mesh), rms_distance(clean, mesh),
          100 * (signed_volume_of(mesh) / signed_volume_of(clean) - 1)};
}

double turned_share(const TriangleMesh& before, const TriangleMesh& after) {
  size_t turned = 0;
  for (size_t t = 0; t < before.triangles.size(); ++t)
    turned += doubled_area_of(before, t).dot(doubled_area_of(after, t)) < 0;
  return static_cast<double>(turned) / static_cast<double>(before.triangles.size());
}

TriangleMesh moved(const TriangleMesh& mesh, const std::vector<Vec3f>& moves, double strength) {
  TriangleMesh result = mesh;
  for (size_t v = 0; v < moves.size(); ++v)
    result.vertices[v] += strength * moves[v].cast<double>();
  return result;
}

}  // namespace burnish
