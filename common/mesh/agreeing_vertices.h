#pragma once

#include <cstdint>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/base/scratch_space.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Returns for each vertex the least vertex at its place that looks alike: the normals of their
/// triangles differ by less than 60 degrees, and their colours by nothing. So a seam of textures
/// shows no line. A crease whose sides have vertices of their own, and sheets back to back, keep a
/// normal for each side. In a soup of triangles normals may differ by up to 120 degrees. Returns an
/// empty array if no two vertices are at one place. Cost: linear time; scratch of 21 bytes per
/// vertex, and four to keep. Throws: WorkCancelled.
ScratchArray<uint32_t> least_that_agree(const MeshView& mesh, const ScratchSpace& space = {},
                                        const LoopPart& part = kUnheardLoop);

}  // namespace burnish
