#pragma once

#include "common/base/heard_loop.h"
#include "common/denoise/welded_surface.h"

namespace burnish {

/// Returns the mean length of the sides of the surface's triangles, file units; 1 if they have no
/// length. The same bits for any number of threads. Throws: WorkCancelled.
double mean_side(const WeldedSurface& surface, const LoopPart& part = kUnheardLoop);

}  // namespace burnish
