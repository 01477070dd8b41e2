#pragma once

#include "common/base/heard_loop.h"
#include "common/mesh/statistics/statistics.h"

namespace burnish {

/// Do the same as without a part, and hear a cancel. Throw: WorkCancelled.
MeshStatistics compute_statistics(const MeshView& mesh, const MeshView& joined,
                                  const ScratchSpace& space, const LoopPart& part);
MeshStatistics compute_statistics(const MeshView& mesh, const ScratchSpace& space,
                                  const LoopPart& part);

}  // namespace burnish
