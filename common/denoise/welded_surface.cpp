#include "common/denoise/welded_surface.h"

#include "common/mesh/joined_mesh.h"

namespace burnish {

static SurfaceTriangles surface_of(const MeshView& mesh, const ScratchArray<uint32_t>& place,
                                   const ScratchSpace& space, const LoopPart& part) {
  const std::span<const uint32_t> places(place.data(), place.size());
  return {{mesh.triangles, places}, mesh.vertices.size(), space, part};
}

WeldedSurface::WeldedSurface(const MeshView& mesh, const ScratchSpace& space, const LoopPart& part)
    : mesh_(mesh),
      place_(least_at_places(mesh.vertices, space, part.of(0, 0.4))),
      is_surface_(surface_of(mesh, place_, space, part.of(0.4, 0.8))) {
  join(space, part.of(0.8, 0.85));
  collect_fans(space, part.of(0.85, 1));
}

void WeldedSurface::join(const ScratchSpace& space, const LoopPart& part) {
  triangles_ = mesh_.triangles;
  bool is_joined = false;
  for (size_t v = 0; v < place_.size(); ++v) is_joined = is_joined || place_[v] != v;
  if (!is_joined) return;
  joined_ = ScratchArray<Triangle>(space, triangle_count());
  parallel_for_heard(part, triangle_count(), [&](size_t t) {
    for (int side = 0; side < 3; ++side) joined_[t][side] = place_[mesh_.triangles[t][side]];
  });
  triangles_ = {joined_.data(), joined_.size()};
}

// Counts a place two entries further up, so that filling moves each start to its own entry.
void WeldedSurface::collect_fans(const ScratchSpace& space, const LoopPart& part) {
  fan_start_ = ScratchArray<uint64_t>(space, vertex_count() + 2);
  for_each_heard(part.of(0, 0.4), triangle_count(), [&](size_t t) {
    if (!is_surface(t)) return;
    for (const uint32_t at : triangle(t)) ++fan_start_[at + 2];
  });
  for (size_t i = 2; i < fan_start_.size(); ++i) fan_start_[i] += fan_start_[i - 1];
  fans_ = ScratchArray<uint32_t>(space, fan_start_.back());
  for_each_heard(part.of(0.4, 1), triangle_count(), [&](size_t t) {
    if (!is_surface(t)) return;
    for (const uint32_t at : triangle(t)) fans_[fan_start_[at + 1]++] = static_cast<uint32_t>(t);
  });
}

}  // namespace burnish
