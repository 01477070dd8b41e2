#pragma once

#include "common/base/heard_loop.h"
#include "common/mesh/statistics/statistics.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/vertex_curvature.h"

namespace burnish {

/// Returns for every vertex the mean, weighted by area, of the tensors of the vertices within
/// `radius` (file units, straight-line distance), each carried into its frame. Vertices that face
/// the other way, such as across a thin sheet, do not count. If vertices are dense for the radius,
/// evenly spread samples stand for the rest. So every radius costs about the same. Needs: radius >
/// 0. Cost: at most 27 · 32 samples a vertex. Throws: WorkCancelled.
ScratchArray<TangentTensor> average_tensors(const MeshView& mesh, const MeshStatistics& statistics,
                                            const VertexCurvature& vertices, double radius,
                                            const ScratchSpace& space, const LoopPart& part);

}  // namespace burnish
