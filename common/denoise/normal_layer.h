#pragma once

#include <limits>
#include <span>
#include <vector>

#include "common/denoise/triangle_normals.h"

namespace burnish {

struct LayerOptions {
  double cap = std::numeric_limits<double>::infinity();  ///< no vertex moves further, file units
  int updates = 20;  ///< of each vertex; 5 show a pass of the filter on its way
};

/// Returns the layer: how far each vertex of the mesh moves, file units, so that triangles take
/// these normals. Vertices at one place move alike. Local updates by area, after Sun et al.,
/// "Fast and Effective Feature-Preserving Mesh Denoising" (2007), section 4. No vertex moves
/// further than `cap`; the corners of triangles that would turn by more than 90 degrees stay. The
/// same bits for any number of threads. Needs: normals as NormalFilter has them, one per triangle
/// of the mesh. Cost: linear; 28 bytes a vertex and 29 a triangle, in `space`. Throws:
/// WorkCancelled, std::bad_alloc.
std::vector<Vec3f> normal_layer(const WeldedSurface& surface,
                                std::span<const NormalAndArea> normals,
                                const LayerOptions& options = {}, const ScratchSpace& space = {},
                                const LoopPart& part = kUnheardLoop);

}  // namespace burnish
