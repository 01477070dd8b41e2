#pragma once

#include "common/mesh/statistics.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/unset_vector.h"

namespace burnish {

/// Principal curvatures and directions of one triangle, constant over it (section 4.2). A triangle
/// without area has zero curvature and arbitrary directions.
struct TriangleCurvature {
  double kappa1 = 0;  ///< 1/file unit, the algebraically larger; > 0 is convex
  double kappa2 = 0;
  Vec3d v1 = Vec3d::UnitX();  ///< orthonormal, in the triangle's plane; v1 belongs to kappa1
  Vec3d v2 = Vec3d::UnitY();
};

/// Computes the curvature of every triangle from the tensors of its three vertices. The triangles'
/// winding tells outside from inside; a closed mesh of negative volume counts as inside out.
/// `averaging_radius` in file units steadies noisy scans; 0 for none. Source: section 4.2;
/// Rusinkiewicz 2004, "Estimating curvatures and their derivatives on triangle meshes". Needs: a
/// valid mesh and its statistics. Cost: linear, with or without a radius; 60 bytes per triangle of
/// scratch. Accuracy: always finite; the same bits for any number of threads.
UnsetVector<TriangleCurvature> compute_curvature(const TriangleMesh& mesh,
                                                 const MeshStatistics& statistics,
                                                 double averaging_radius);

}  // namespace burnish
