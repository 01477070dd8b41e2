#pragma once

#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/denoise/welded_surface.h"

namespace burnish {

/// Three coordinates and a number beside them, in one register.
using Float4 = float __attribute__((vector_size(16)));

/// A unit normal, and the area over the mean area of the surface's triangles. All 0 for a triangle
/// that is no surface, or has no area.
using NormalAndArea = Float4;

/// Returns one per triangle. Cost: 16 bytes each, in `space`. Throws: WorkCancelled,
/// std::bad_alloc.
ScratchArray<NormalAndArea> triangle_normals(const WeldedSurface& surface,
                                             const ScratchSpace& space = {},
                                             const LoopPart& part = kUnheardLoop);

inline Vec3d normal_of(const NormalAndArea& of) {
  return {of[0], of[1], of[2]};
}

}  // namespace burnish
