#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/base/check.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish::reference {

/// The distance of two surfaces with the same triangles, over the bounding-box diagonal.
struct Distance {
  double max = 0;
  double rms = 0;
};

/// Returns the distance between vertices of the same index. Needs: equal counts, diagonal > 0. A
/// vertex that is not finite makes both figures NaN, which fails every bar.
inline Distance vertex_distance(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b,
                                double diagonal) {
  BURNISH_CHECK(a.size() == b.size(),
                "vertex " + std::to_string(std::min(a.size(), b.size())) + " has no counterpart");
  Distance distance;
  double sum = 0;
  for (size_t v = 0; v < a.size(); ++v) {
    const double d = (a[v] - b[v]).norm() / diagonal;
    if (!std::isfinite(d)) return {NAN, NAN};
    distance.max = std::max(distance.max, d);
    sum += d * d;
  }
  if (!a.empty()) distance.rms = std::sqrt(sum / static_cast<double>(a.size()));
  return distance;
}

/// Returns the diagonal of the box around the referenced vertices, file units.
inline double box_diagonal(const TriangleMesh& mesh) {
  Vec3d least = Vec3d::Constant(INFINITY);
  Vec3d most = -least;
  for (const Triangle& t : mesh.triangles) {
    for (uint32_t v : t) {
      least = least.cwiseMin(mesh.vertices[v]);
      most = most.cwiseMax(mesh.vertices[v]);
    }
  }
  return (most - least).norm();
}

}  // namespace burnish::reference
