#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/denoise/denoise.h"
#include "common/denoise/surface_filter.h"
#include "server/fields/fields_view.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/cycle/multigrid.h"
#include "server/solver/solver.h"

namespace burnish {

/// The parts of a filter of kept edges: they are made once, and serve any strength. Immutable; the
/// scan outlives them.
struct EdgeParts {
  EdgeFilter filter;  ///< its strength says nothing
  std::shared_ptr<const DenoiseSurface> surface;
  std::shared_ptr<SurfaceFilter> on;  ///< what filters the surface
  std::shared_ptr<const FilteredSurface> filtered;
  std::vector<TargetGradient> target;  ///< one per cell

  uint64_t byte_count() const;
};

/// Returns whether two filters give the same normals.
bool has_same_normals(const EdgeFilter& a, const EdgeFilter& b);

/// Makes the parts of a filter where sessions of `backend` are solved. It takes from those of
/// another one what is the same: the surface, and for another crispness the normals. `before`: may
/// be null. Fails: cancelled; resource_exhausted; internal_error if the device has failed.
Result<std::shared_ptr<const EdgeParts>> make_edge_parts(
    const PreparedMesh& prepared, BackendKind backend, const EdgeFilter& filter,
    const std::shared_ptr<const EdgeParts>& before, const Progress& progress = {});

/// Returns the bytes that kept edges take in a session: two filters' parts, what is needed while
/// one is made, and what frames need. Accuracy: no less than they take, for meshes whose vertices
/// have six triangles on average.
uint64_t predict_edge_bytes(const Multigrid& on);

}  // namespace burnish
