#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/measure/plane.h"

namespace burnish {

/// Limit of the points of one section, so that its answer fits into one message.
inline constexpr size_t kSectionPointsMax = 150'000;

/// A line in which a plane cuts a surface, in the plane's axes: right, up.
struct SectionLine {
  std::vector<Eigen::Vector2d>
      points;  ///< two or more, file units; a closed line repeats its first

  bool is_closed() const { return points.size() > 2 && points.front() == points.back(); }
};

/// Cuts a surface. A vertex in the plane counts as above it. So each triangle that has vertices on
/// both sides adds one piece, and lines end only at the surface's boundary or where more than two
/// triangles meet. Lines come in the order of their first triangle.
/// Needs: triangles that index the vertices. Fails: resource_exhausted above kSectionPointsMax.
Result<std::vector<SectionLine>> cut_surface(std::span<const Vec3d> vertices,
                                             std::span<const Triangle> triangles,
                                             const Plane& plane);

/// A section through the surface before and after its edits.
struct Section {
  std::vector<SectionLine> original;
  std::vector<SectionLine> edited;
};

}  // namespace burnish
