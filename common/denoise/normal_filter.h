#pragma once

#include <span>

#include "common/denoise/triangle_normals.h"
#include "common/denoise/triangle_rings.h"
#include "common/edit/edge_filter.h"

namespace burnish {

/// Filters the normals of a surface's triangles, pass by pass; each pass is a valid answer.
/// Bilateral as Zheng et al., "Bilateral Normal Filtering for Mesh Denoising" (2011); edges as
/// Zhang et al., "Guided Mesh Normal Filtering" (2015), with a soft choice of the ring, so that
/// rounding changes no choice. Pairs weigh by the surface's own places and areas in all passes. The
/// same bits for any number of threads.
class NormalFilter {
 public:
  /// Needs: `rings` are those of `surface`, and both outlive this; valid options. Cost: 4 bytes a
  /// pair of rings and 32 a triangle (edges: 64), in `space`; 24 a triangle while it is made.
  /// Throws: WorkCancelled, std::bad_alloc.
  NormalFilter(const WeldedSurface& surface, const TriangleRings& rings, NormalFilterKind kind,
               double sigma, const ScratchSpace& space = {}, const LoopPart& part = kUnheardLoop);

  /// Begins anew with the normals of the triangles and another σ. It keeps the weights of places,
  /// which take longer than a pass. Throws: WorkCancelled; the filter is then as it was.
  void restart(double sigma, const LoopPart& part = kUnheardLoop);

  /// Throws: WorkCancelled; the normals are then those of before.
  void pass(const LoopPart& part = kUnheardLoop);

  /// One per triangle of the mesh. All 0 for a triangle that is no surface. One without area has no
  /// normal at first, and takes that of its ring.
  std::span<const NormalAndArea> normals() const { return {now_.data(), now_.size()}; }

 private:
  void make_guides(const LoopPart& part);

  const WeldedSurface& surface_;
  const TriangleRings& rings_;
  const ScratchSpace space_;
  const bool is_guided_;
  float steepness_;  // 1/σ²
  ScratchArray<NormalAndArea> now_, next_;
  ScratchArray<Float4> guides_, measured_;  // empty without guides
  ScratchArray<float> nearness_;
};

}  // namespace burnish
