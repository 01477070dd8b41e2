#pragma once

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/tangent_tensor.h"

namespace burnish {

/// Normal, second fundamental form and Voronoi area of every vertex; lengths in units of `unit`.
/// All are zero for a vertex without a triangle that has a plane, or whose triangles cancel out.
struct VertexCurvature {
  ScratchArray<Vec3d> normals;
  ScratchArray<TangentTensor> tensors;  ///< in make_frame(normal)
  ScratchArray<double> areas;

  bool has_normal(size_t v) const { return !normals[v].isZero(0); }
};

/// Source: Rusinkiewicz 2004, section 3. Throws: WorkCancelled.
VertexCurvature compute_vertex_curvature(const MeshView& mesh, double unit,
                                         const ScratchSpace& space,
                                         const LoopPart& part = kUnheardLoop);

}  // namespace burnish
