#pragma once

#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/fields/fields_view.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The surface that is believed to be under the noise, by its normals, and a layer that is already
/// on its way there.
struct SurfaceTarget {
  std::span<const Vec3f> normals;  ///< one per triangle, of length 1; 0: it is no surface
  std::span<const Vec3f> layer;    ///< one per vertex: its displacement at crispness 1, file units
  double crispness = 0;            ///< c, 0 to 1: the part of the layer that counts
};

/// Returns the matrices that lead each cell from its own gradient to the target's. In a triangle
/// with the normal n and the wanted one m, the layer w leaves D = −m mᵀ (∇x + c∇w) to do. T2 ∇x is
/// nearest to D and T1 ∇x to c∇w + D over the pieces of surface in the cell, by area. A cell has
/// zeros if its surface is too small to tell, or has two sides that face away from each other: one
/// matrix cannot lead both. The same bits for any number of threads.
/// Shapes: one per cell. Fails: cancelled.
Result<std::vector<TargetGradient>> fit_target(const PreparedMesh& prepared,
                                               const SurfaceTarget& target,
                                               const Progress& progress = {});

}  // namespace burnish
