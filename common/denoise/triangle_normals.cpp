#include "common/denoise/triangle_normals.h"

#include <cmath>

#include "common/denoise/heard_blocks.h"

namespace burnish {

/// Twice the area along the normal; 0 for a triangle that is no surface.
static Vec3d doubled_area(const WeldedSurface& surface, size_t t) {
  if (!surface.is_surface(t)) return Vec3d::Zero();
  const auto [a, b, c] = corners_of(surface.mesh(), t);
  return (b - a).cross(c - a);
}

ScratchArray<NormalAndArea> triangle_normals(const WeldedSurface& surface,
                                             const ScratchSpace& space, const LoopPart& part) {
  const size_t count = surface.triangle_count();
  const double sum =
      heard_sum(part.of(0, 0.4), count, [&](size_t t) { return doubled_area(surface, t).norm(); });
  const double mean = sum / static_cast<double>(surface.surface_count());
  ScratchArray<NormalAndArea> normals(space, count);
  parallel_for_heard(part.of(0.4, 1), count, [&](size_t t) {
    const Vec3d doubled = doubled_area(surface, t);
    const double length = doubled.norm();
    if (!(length > 0)) return;
    const Vec3f unit = (doubled / length).cast<float>();
    normals[t] = NormalAndArea{unit.x(), unit.y(), unit.z(), static_cast<float>(length / mean)};
  });
  return normals;
}

}  // namespace burnish
