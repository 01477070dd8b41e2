#include "common/denoise/ring_nearness.h"

#include <cmath>

#include "common/base/dispatch.h"
#include "common/denoise/exp8.h"
#include "common/denoise/heard_blocks.h"

namespace burnish {
namespace {

ScratchArray<Vec3d> centres_of(const MeshView& mesh, const ScratchSpace& space,
                               const LoopPart& part) {
  ScratchArray<Vec3d> centres(space, mesh.triangles.size());
  parallel_for_heard(part, centres.size(), [&](size_t t) {
    const auto [a, b, c] = corners_of(mesh, t);
    centres[t] = a + ((b - a) + (c - a)) / 3;
  });
  return centres;
}

double mean_distance(const ScratchArray<Vec3d>& centres, const TriangleRings& rings,
                     const LoopPart& part) {
  const double sum = heard_sum(part, rings.size(), [&](size_t t) {
    double of_ring = 0;
    for (const uint32_t other : rings[t]) of_ring += (centres[other] - centres[t]).norm();
    return of_ring;
  });
  return sum > 0 ? sum / static_cast<double>(rings.pair_count()) : 1;
}

}  // namespace

BURNISH_DISPATCH static void weigh(float* exponents, const uint32_t* triangles, size_t count,
                                   const NormalAndArea* normals) {
  exp_in_place(exponents, count);
  for (size_t i = 0; i < count; ++i) exponents[i] *= normals[triangles[i]][3];
}

ScratchArray<float> ring_nearness(const WeldedSurface& surface, const TriangleRings& rings,
                                  std::span<const NormalAndArea> normals, double reach,
                                  const ScratchSpace& space, const LoopPart& part) {
  const ScratchArray<Vec3d> centres = centres_of(surface.mesh(), space, part.of(0, 0.1));
  const double radius = reach * mean_distance(centres, rings, part.of(0.1, 0.5));
  const double scale = 1 / radius;
  ScratchArray<float> nearness(space, rings.pair_count());
  for_each_block_heard(part.of(0.5, 1), rings.size(), [&](size_t begin, size_t end) {
    const uint64_t first = rings.starts()[begin], last = rings.starts()[end];
    float* exponent = nearness.data() + first;
    for (size_t t = begin; t < end; ++t)
      for (const uint32_t other : rings[t]) {
        const Vec3d way = (centres[other] - centres[t]) * scale;
        *exponent++ = static_cast<float>(-0.5 * way.squaredNorm());
      }
    weigh(nearness.data() + first, rings.triangles() + first, last - first, normals.data());
  });
  return nearness;
}

}  // namespace burnish
