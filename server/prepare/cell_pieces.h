#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/scratch_array.h"
#include "common/base/status.h"
#include "common/grid/morton.h"
#include "server/prepare/grid_mesh.h"
#include "server/prepare/passages.h"
#include "server/prepare/piece_count.h"

namespace burnish {

/// Triangle `triangle` meets cell `cell` and the neighbours in `passages`.
struct CellPiece {
  MortonKey cell;
  uint32_t triangle;
  Passages passages;
};

/// Memory for pieces, and how many are sorted at once.
struct PieceRoom {
  ScratchSpace space;
  uint64_t pieces_per_brick = kPiecesPerBrick;

  static constexpr uint64_t kPiecesPerBrick = uint64_t{1} << 20;
};

/// Returns every counted piece, sorted by cell, then triangle. Deals the pieces to bricks and sorts
/// brick by brick: the same pieces for bricks of any size. Fails: cancelled.
Result<ScratchArray<CellPiece>> find_cell_pieces(const GridMesh& mesh, const PieceCount& count,
                                                 const PieceRoom& room, const Progress& progress);

/// Returns how many cells the pieces have. Needs: sorted pieces.
uint64_t count_cells(std::span<const CellPiece> pieces);

/// Cuts the pieces between cells into chunks for threads. Returns where each begins, and the end.
std::vector<size_t> chunks_of_cells(std::span<const CellPiece> pieces);

/// Returns where the cell of the piece at `begin` ends. Needs: begin < pieces.size().
inline size_t end_of_cell(std::span<const CellPiece> pieces, size_t begin) {
  size_t end = begin + 1;
  while (end < pieces.size() && pieces[end].cell == pieces[begin].cell) ++end;
  return end;
}

}  // namespace burnish
