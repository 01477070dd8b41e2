#pragma once

#include <cstdint>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "server/prepare/pages/page_vertices.h"

namespace burnish {

/// The planes between cells, of any depth, on which a vertex lies: a bit for each axis.
struct PlaneSides {
  uint8_t on = 0;
  /// All triangles of the place lie below the plane or in it, one at least below. The cell above
  /// has no surface then.
  uint8_t below = 0;
};

/// Finds the planes of every vertex. A vertex so near a plane that snap_to_planes() puts it there
/// lies on it. Vertices of one place count as one. Throws: WorkCancelled.
ScratchArray<PlaneSides> find_plane_sides(const PagesInput& scan, const PageGrid& grid,
                                          const ScratchSpace& space, const LoopPart& part);

}  // namespace burnish
