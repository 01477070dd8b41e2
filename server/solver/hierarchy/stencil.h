#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/solver/hierarchy/row_tiles.h"
#include "server/solver/hierarchy/sheets/irregular_rows.h"

namespace burnish {

/// Says which corners have a matrix entry with which other corners: the off-diagonal pattern of
/// every matrix of one depth, in compressed rows.
///
/// Within each window of kRowWindow corners the rows are stored by rising length. A loop over rows
/// then seldom meets a new length; a mispredicted end costs as much as a row. Each row is padded to
/// a multiple of kRowPadding entries by the corner itself, whose entry is zero there.
struct Stencil {
  static constexpr int32_t kRowWindow = 256;
  static constexpr int kRowPadding = 4;

  std::vector<int32_t> corner_of_row;
  std::vector<int32_t> row_of_corner;
  std::vector<int64_t> row_start;  ///< rows + 1
  std::vector<int32_t> column;     ///< in slot order within a row; rising in an irregular row
  std::vector<uint32_t> mask;  ///< bit s of mask[I]: corner I has slot s; 0 for an irregular row
  RowTiles tiles;
  IrregularRows irregular;
  IrregularCells irregular_cells;

  /// Returns whether slots cannot describe the corner's row.
  bool is_irregular(int32_t corner) const { return mask[corner] == 0; }

  struct Row {
    int64_t begin, end;
  };
  /// Returns the places of a corner's entries in `column`, without padding.
  Row row(int32_t corner) const {
    const int32_t stored = row_of_corner[corner];
    const int64_t begin = row_start[stored];
    if (!is_irregular(corner)) return {begin, begin + __builtin_popcount(mask[corner])};
    int64_t end = row_start[stored + 1];
    while (end > begin && column[end - 1] == corner) --end;
    return {begin, end};
  }
  /// Returns where slot s of corner I stands in `column`. Needs: the corner has the slot.
  int64_t position(int32_t corner, int slot) const {
    return row_start[row_of_corner[corner]] + __builtin_popcount(mask[corner] & ((1u << slot) - 1));
  }
};

static_assert(RowTiles::kRows % Stencil::kRowWindow == 0);

/// Makes corners neighbours if they share a cell or are tied.
Stencil make_stencil(const SparseGrid& grid, std::span<const CellTie> ties);

}  // namespace burnish
