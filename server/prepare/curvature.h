#pragma once

#include "common/base/heard_loop.h"
#include "common/mesh/statistics/statistics.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/vertex_curvature.h"

namespace burnish {

/// Principal curvatures and directions of one triangle, constant over it (section 4.2). A triangle
/// without area has zero curvature and arbitrary directions.
struct TriangleCurvature {
  double kappa1 = 0;  ///< 1/file unit, the algebraically larger; > 0 is convex
  double kappa2 = 0;
  Vec3d v1 = Vec3d::UnitX();  ///< orthonormal, in the triangle's plane; v1 belongs to kappa1
  Vec3d v2 = Vec3d::UnitY();
};

/// The curvature of a mesh. Keeps the tensors of the vertices, and makes the curvature of a
/// triangle from its three vertices when it is asked. The triangles' winding tells outside from
/// inside; a closed mesh of negative volume counts as inside out. Source: section 4.2; Rusinkiewicz
/// 2004, "Estimating curvatures and their derivatives on triangle meshes". Accuracy: always finite;
/// the same bits for any number of threads.
class MeshCurvature {
 public:
  /// `averaging_radius` in file units steadies noisy scans; 0 for none. Needs: a valid mesh that
  /// outlives this, and its statistics. Cost: linear, with or without a radius; 36 bytes per
  /// triangle of scratch, and 64 per vertex to keep, both in `space`. Throws: WorkCancelled.
  MeshCurvature(const MeshView& mesh, const MeshStatistics& statistics, double averaging_radius,
                const ScratchSpace& space, const LoopPart& part = kUnheardLoop);

  /// Threads may ask at the same time.
  TriangleCurvature of(uint32_t triangle) const;

  /// Returns the mean normal of a triangle's vertices: noise of a vertex turns it little. A unit
  /// vector as the winding tells, or zero if they cancel out.
  Vec3d normal_of(uint32_t triangle) const;

 private:
  MeshView mesh_;
  double unit_;
  double to_file_units_;
  VertexCurvature vertices_;
};

}  // namespace burnish
