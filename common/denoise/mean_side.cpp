#include "common/denoise/mean_side.h"

#include "common/denoise/heard_blocks.h"

namespace burnish {

double mean_side(const WeldedSurface& surface, const LoopPart& part) {
  const double sum = heard_sum(part, surface.triangle_count(), [&](size_t t) {
    if (!surface.is_surface(t)) return 0.0;
    const auto [a, b, c] = corners_of(surface.mesh(), t);
    return (b - a).norm() + (c - b).norm() + (a - c).norm();
  });
  return sum > 0 ? sum / static_cast<double>(3 * surface.surface_count()) : 1;
}

}  // namespace burnish
