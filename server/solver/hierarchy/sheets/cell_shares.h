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

/// Says how the corners of a cell follow from the corners of one cell of the depth above. Corner a
/// lies at place[a] of its 3×3×3 half-way points and takes weight[a] of the value there; 0 for no
/// value.
struct CellPart {
  std::array<float, kCornersPerCell> weight;
  std::array<uint8_t, kCornersPerCell> place;
};

/// One summand Lᵀ N R of the 8×8 numbers of a coarse cell or tie. N holds the numbers of a cell of
/// the finer depth if source < its cells: symmetric, the diagonal is the row sum less the pairs.
/// Else N holds the numbers of a tie, or at the finest depth of a sheet (source is its number
/// beyond the cells), and may be transposed. L and R are Q of its parts.
struct CellShare {
  int32_t source;
  int32_t left, right;  ///< into CellShares::part
  int32_t is_transposed;
};

/// The summands of a coarse depth's cells and ties beyond the sums over children.
struct CellShares {
  std::vector<CellPart> part;   ///< the first eight belong to a parent's octants
  std::vector<int32_t> target;  ///< rising; a cell, or cells + a tie
  std::vector<int32_t> start;   ///< targets + 1, into share
  std::vector<CellShare> share;
  /// The finer depth's cells that are not a child of a cell; rising.
  std::vector<int32_t> apart;
};

/// The ties of a coarse depth, and the shares of its ties and cells.
struct TiesAndShares {
  std::vector<CellTie> ties;
  CellShares shares;
};

/// From the finest depth: the cells with several sheets, or with a corner that has several copies.
TiesAndShares share_cells(const SparseGrid& finest, const SheetCorners& sheets,
                          const CoarseGrid& coarse);

/// From a coarse depth: its ties, and each child of a cell after the eighth.
TiesAndShares share_ties(const SparseGrid& fine, std::span<const CellTie> ties,
                         const CoarseGrid& coarse);

}  // namespace burnish
