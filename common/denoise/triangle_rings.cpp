#include "common/denoise/triangle_rings.h"

#include <algorithm>

namespace burnish {
namespace {

/// Corners whose fans were walked.
struct WalkedCorners {
  Triangle place;
  int count = 0;

  bool has_any_of(const Triangle& t) const {
    for (int i = 0; i < count; ++i)
      if (t[0] == place[i] || t[1] == place[i] || t[2] == place[i]) return true;
    return false;
  }
};

/// Calls visit(triangle) once for each one of the ring.
template <typename Visit>
void for_each_in_ring(const WeldedSurface& surface, uint32_t t, const Visit& visit) {
  if (!surface.is_surface(t)) return;
  WalkedCorners walked;
  for (const uint32_t corner : surface.triangle(t)) {
    const auto fan = surface.fan(corner);
    if (fan.size() > kFanTrianglesMax) continue;
    for (const uint32_t other : fan)
      if (other != t && !walked.has_any_of(surface.triangle(other))) visit(other);
    walked.place[walked.count++] = corner;
  }
}

}  // namespace

TriangleRings::TriangleRings(const WeldedSurface& surface, const ScratchSpace& space,
                             const LoopPart& part)
    : start_(space, surface.triangle_count() + 1) {
  parallel_for_heard(part.of(0, 0.5), size(), [&](size_t t) {
    uint64_t count = 0;
    for_each_in_ring(surface, static_cast<uint32_t>(t), [&](uint32_t) { ++count; });
    start_[t + 1] = count;
  });
  for (size_t t = 0; t < size(); ++t) start_[t + 1] += start_[t];
  triangle_ = ScratchArray<uint32_t>(space, start_.back());
  parallel_for_heard(part.of(0.5, 1), size(), [&](size_t t) {
    uint32_t* next = triangle_.data() + start_[t];
    for_each_in_ring(surface, static_cast<uint32_t>(t), [&](uint32_t other) { *next++ = other; });
  });
}

}  // namespace burnish
