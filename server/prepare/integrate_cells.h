#pragma once

#include "common/base/progress.h"
#include "common/base/scratch_array.h"
#include "common/base/status.h"
#include "server/prepare/prepared_mesh.h"
#include "server/prepare/surface.h"

namespace burnish {

/// Keeps the results of each cell with surface. Shapes: one entry per cell, cells strictly rising.
struct CellArrays {
  ScratchArray<MortonKey> cells;
  ScratchArray<CellIntegrals> integrals;
  ScratchArray<CellCurvature> curvature;
  ScratchArray<Passages> passages;
};

/// Integrates over the pieces of each cell, in the order of their triangles. Leaves out cells
/// without area. `cells` is count_cells(pieces). Fails: cancelled.
Result<CellArrays> integrate_cells(const Surface& surface, std::span<const CellPiece> pieces,
                                   uint64_t cells, const ScratchSpace& space,
                                   const Progress& progress);

}  // namespace burnish
