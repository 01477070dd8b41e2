#include "common/mesh/triangle_mesh.h"

#include <cmath>

#include <Eigen/Geometry>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/mesh/heard_validate.h"

namespace burnish {

static Status check_counts(const MeshView& mesh) {
  const auto check = [](const char* what, uint64_t count, uint64_t limit) {
    if (count <= limit) return Status::ok();
    return invalid_argument("mesh has " + std::to_string(count) + " " + what + ", the limit is " +
                            std::to_string(limit));
  };
  if (mesh.triangles.empty()) return invalid_argument("mesh has no triangles");
  RETURN_IF_ERROR(check("vertices", mesh.vertices.size(), kVerticesMax));
  RETURN_IF_ERROR(check("triangles", mesh.triangles.size(), kTrianglesMax));
  if (mesh.has_colours() && mesh.colours.size() != mesh.vertices.size())
    return invalid_argument("mesh has " + std::to_string(mesh.colours.size()) + " colours for " +
                            std::to_string(mesh.vertices.size()) + " vertices");
  return Status::ok();
}

static Status check_vertices(const MeshView& mesh, FileSteps& steps) {
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    steps.take();
    for (int axis = 0; axis < 3; ++axis) {
      const double x = mesh.vertices[v][axis];
      if (std::abs(x) <= kCoordinateMagnitudeMax) continue;  // false for NaN
      return invalid_argument("vertex " + std::to_string(v) + " has " + "xyz"[axis] + " = " +
                              shortest_text(x) + "; coordinates must be finite and within ±1e18");
    }
  }
  return Status::ok();
}

static Status check_triangles(const MeshView& mesh, FileSteps& steps) {
  double twice_area = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    steps.take();
    const Triangle& triangle = mesh.triangles[t];
    for (uint32_t v : triangle) {
      if (v < mesh.vertices.size()) continue;
      return invalid_argument("triangle " + std::to_string(t) + " refers to vertex " +
                              std::to_string(v) + ", but there are " +
                              std::to_string(mesh.vertices.size()));
    }
    const Vec3d& a = mesh.vertices[triangle[0]];
    twice_area += (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).norm();
  }
  if (twice_area > 0 && std::isfinite(twice_area)) return Status::ok();
  return invalid_argument("mesh has no area: all " + std::to_string(mesh.triangles.size()) +
                          " triangles are degenerate, or smaller than 1e-77");
}

Status validate(const MeshView& mesh, FileSteps steps) {
  RETURN_IF_ERROR(check_counts(mesh));
  RETURN_IF_ERROR(check_vertices(mesh, steps));
  return check_triangles(mesh, steps);
}

Status validate(const MeshView& mesh) {
  return validate(mesh, FileSteps());
}

}  // namespace burnish
