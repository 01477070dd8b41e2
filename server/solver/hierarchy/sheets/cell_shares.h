#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/solver/hierarchy/coarse_grid.h"
#include "server/solver/hierarchy/sheets/irregular_rows.h"
#include "server/solver/hierarchy/sheets/sheet_corners.h"

namespace burnish {

/// How the corners of a cell follow from those of one cell of the depth above: corner a stands at
/// place[a] of its 3×3×3 half-way points, and takes weight[a] of what that has; 0 where nothing.
struct CellPart {
  std::array<float, kCornersPerCell> weight;
  std::array<uint8_t, kCornersPerCell> place;
};

/// One summand Lᵀ N R of a coarse cell's or tie's 8×8 numbers. N are those of a cell of the finer
/// depth (source < its cells, symmetric, the diagonal being the row sum less the pairs), or of a
/// tie or at the finest depth of a sheet (its number beyond the cells), which may be transposed; L
/// and R are Q of its parts.
struct CellShare {
  int32_t source;
  int32_t left, right;  ///< into CellShares::part
  int32_t is_transposed;
};

/// What a coarse depth's cells and ties take from the finer depth beyond what its children give.
struct CellShares {
  std::vector<CellPart> part;   ///< the first eight are those of a parent's octants
  std::vector<int32_t> target;  ///< rising: a cell, or cells + a tie
  std::vector<int32_t> start;   ///< targets + 1, into share
  std::vector<CellShare> share;
  /// The finer depth's cells that are no cell's child: rising.
  std::vector<int32_t> apart;
};

/// The ties of a coarse depth, and what they and its cells take.
struct TiesAndShares {
  std::vector<CellTie> ties;
  CellShares shares;
};

/// From the finest depth: the cells with several sheets, or a corner that has several copies.
TiesAndShares share_cells(const SparseGrid& finest, const SheetCorners& sheets,
                          const CoarseGrid& coarse);

/// From a coarse depth: its ties, and of children those that are the ninth or more of a cell.
TiesAndShares share_ties(const SparseGrid& fine, std::span<const CellTie> ties,
                         const CoarseGrid& coarse);

}  // namespace burnish
