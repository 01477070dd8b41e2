#pragma once

#include "common/denoise/triangle_normals.h"
#include "common/denoise/triangle_rings.h"
#include "common/edit/edge_filter.h"

namespace burnish {

/// Returns how far a triangle looks, as a share of the mean distance of centres. A guided one does
/// not stray over edges, so it looks further.
constexpr double reach_of(NormalFilterKind kind) {
  return kind == NormalFilterKind::kEdges ? 2 : 1;
}

/// Returns for each pair of `rings` how much the other triangle says about the first one by place:
/// A_j exp(-|c_t - c_j|² / 2ρ²) of the centres c and areas A of the surface. ρ is `reach` times the
/// mean distance of centres in a ring. Cost: 4 bytes a pair, in `space`. Throws: WorkCancelled,
/// std::bad_alloc.
ScratchArray<float> ring_nearness(const WeldedSurface& surface, const TriangleRings& rings,
                                  std::span<const NormalAndArea> normals, double reach,
                                  const ScratchSpace& space = {},
                                  const LoopPart& part = kUnheardLoop);

}  // namespace burnish
