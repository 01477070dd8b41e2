#include "common/denoise/ring_nearness.h"

#include <algorithm>
#include <cmath>

#include "common/base/dispatch.h"
#include "common/denoise/exp8.h"
#include "common/denoise/heard_blocks.h"
#include "common/denoise/mean_side.h"

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

}  // namespace

/// Turns squares of distances into weights.
BURNISH_DISPATCH static void weigh(float* squares, const uint32_t* triangles, size_t count,
                                   float factor, const NormalAndArea* normals) {
  for (size_t i = 0; i < count; ++i) squares[i] *= factor;
  exp_in_place(squares, count);
  for (size_t i = 0; i < count; ++i) squares[i] *= normals[triangles[i]][3];
}

ScratchArray<float> ring_nearness(const WeldedSurface& surface, const TriangleRings& rings,
                                  std::span<const NormalAndArea> normals, double reach,
                                  const ScratchSpace& space, const LoopPart& part) {
  // Floats hold squares of distances beside a side.
  const double scale = 1 / mean_side(surface, part.of(0, 0.1));
  const ScratchArray<Vec3d> centres = centres_of(surface.mesh(), space, part.of(0.1, 0.2));
  ScratchArray<float> nearness(space, rings.pair_count());
  const double sum = heard_sum(part.of(0.2, 0.7), rings.size(), [&](size_t t) {
    float* square = nearness.data() + rings.starts()[t];
    double distances = 0;
    for (const uint32_t other : rings[t]) {
      const double squared = ((centres[other] - centres[t]) * scale).squaredNorm();
      *square++ = static_cast<float>(squared);
      distances += std::sqrt(squared);
    }
    return distances;
  });
  const double radius = reach * sum / static_cast<double>(std::max<uint64_t>(1, nearness.size()));
  const auto factor = static_cast<float>(radius > 0 ? -0.5 / (radius * radius) : -0.5);
  for_each_block_heard(part.of(0.7, 1), rings.size(), [&](size_t begin, size_t end) {
    const uint64_t first = rings.starts()[begin], last = rings.starts()[end];
    weigh(nearness.data() + first, rings.triangles() + first, last - first, factor, normals.data());
  });
  return nearness;
}

}  // namespace burnish
