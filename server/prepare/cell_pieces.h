#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/grid/morton.h"
#include "server/prepare/passages.h"
#include "server/prepare/unset_vector.h"

namespace burnish {

/// Triangle `triangle` meets cell `cell` and the neighbours in `passages`.
struct CellPiece {
  MortonKey cell;
  uint32_t triangle;
  Passages passages;
};

/// The number of pieces, by blocks of triangles.
struct PieceCount {
  std::vector<uint64_t> start;  ///< the first piece of each block, and the end
  uint64_t total() const { return start.back(); }
};

/// Counts the (cell, triangle) pairs. Triangles without area, except for rounding, are in no cell.
/// Shapes: one snapped grid position per vertex. Units: grid. Cost: less than a tenth of a
/// preparation. It ends soon after `pieces_max`, because large triangles in a fine grid have too
/// many cells to count. Fails: resource_exhausted above pieces_max.
Result<PieceCount> count_cell_pieces(std::span<const Triangle> triangles,
                                     std::span<const Vec3d> grid_positions, uint64_t pieces_max);

/// Returns every counted pair, sorted by cell, then triangle. Fails: cancelled.
Result<UnsetVector<CellPiece>> find_cell_pieces(std::span<const Triangle> triangles,
                                                std::span<const Vec3d> grid_positions,
                                                const PieceCount& count, const Progress& progress);

/// Returns how many cells the pairs have, without more memory than their keys take.
uint64_t count_cells(std::span<const Triangle> triangles, std::span<const Vec3d> grid_positions,
                     const PieceCount& count);
uint64_t count_cells(std::span<const CellPiece> pieces);

/// Returns where each cell's pieces begin, and the end.
std::vector<size_t> cell_starts(std::span<const CellPiece> pieces);

}  // namespace burnish
