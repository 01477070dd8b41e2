#pragma once

#include "common/base/heard_loop.h"
#include "common/evaluation/evaluation.h"

namespace burnish {

/// Does the same as without a part, and hears a cancel. Throws: WorkCancelled.
void make_evaluation(const MeshView& mesh, const GridFrame& frame, std::span<const MortonKey> cells,
                     std::span<EvaluationPoint> points, const LoopPart& part);

}  // namespace burnish
