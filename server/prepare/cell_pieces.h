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

/// Triangle `triangle` meets cell `cell`, and of its neighbours those in `passages`.
struct CellPiece {
  MortonKey cell;
  uint32_t triangle;
  Passages passages;
};

/// How many pieces there are, by blocks of triangles.
struct PieceCount {
  std::vector<uint64_t> start;  ///< where each block's pieces begin, and the end
  uint64_t total() const { return start.back(); }
};

/// Counts the (cell, triangle) pairs. Triangles without area, but for rounding, are in no cell.
/// Shapes: one snapped grid position per vertex. Units: grid.
/// Cost: less than a tenth of a preparation; ends soon after `pieces_max`, for large triangles in a
/// fine grid have more cells than could be counted to.
/// Fails: resource_exhausted above pieces_max.
Result<PieceCount> count_cell_pieces(std::span<const Triangle> triangles,
                                     std::span<const Vec3d> grid_positions, uint64_t pieces_max);

/// Every pair that was counted, sorted by cell, then triangle. Fails: cancelled.
Result<UnsetVector<CellPiece>> find_cell_pieces(std::span<const Triangle> triangles,
                                                std::span<const Vec3d> grid_positions,
                                                const PieceCount& count, const Progress& progress);

/// How many cells the pairs are of, without more memory than their keys take.
uint64_t count_cells(std::span<const Triangle> triangles, std::span<const Vec3d> grid_positions,
                     const PieceCount& count);
uint64_t count_cells(std::span<const CellPiece> pieces);

/// Where each cell's pieces begin; one entry past the last cell.
std::vector<size_t> cell_starts(std::span<const CellPiece> pieces);

}  // namespace burnish
