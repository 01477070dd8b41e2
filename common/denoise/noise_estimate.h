#pragma once

#include "common/base/heard_loop.h"
#include "common/denoise/welded_surface.h"

namespace burnish {

/// Returns the deviation of a scan's noise along its normals, file units: the lower quartile of how
/// far places leave the surface that the places around them foretell, twice over, so that bends
/// cancel. It speaks of the flatter parts: edges and letters do not count while they are less than
/// half of the places. Right within a fifth for noise of each vertex's own, of 0.1 to 0.3 mean
/// edges. Noise that neighbours share is seen in part: half of that of structured light. 0 if no
/// place is in three triangles. The same bits for any number of threads. Cost: linear; 32 bytes a
/// vertex while it runs. Throws: WorkCancelled, std::bad_alloc.
double noise_deviation(const WeldedSurface& surface, const LoopPart& part = kUnheardLoop);

}  // namespace burnish
