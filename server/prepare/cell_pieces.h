#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/grid/morton.h"
#include "common/mesh/triangle_mesh.h"
#include "server/prepare/passages.h"
#include "server/prepare/unset_vector.h"

namespace burnish {

/// Triangle `triangle` meets cell `cell`, and of its neighbours those in `passages`.
struct CellPiece {
  MortonKey cell;
  uint32_t triangle;
  Passages passages;
};

/// Every (cell, triangle) pair, sorted by cell, then triangle. Triangles without area, but for
/// rounding, are in no cell.
/// Shapes: one snapped grid position per vertex. Units: grid.
/// Fails: cancelled; resource_exhausted when the pairs alone exceed the machine's free memory.
Result<UnsetVector<CellPiece>> find_cell_pieces(std::span<const Triangle> triangles,
                                                std::span<const Vec3d> grid_positions,
                                                const Progress& progress);

/// Where each cell's pieces begin; one entry past the last cell.
std::vector<size_t> cell_starts(std::span<const CellPiece> pieces);

}  // namespace burnish
