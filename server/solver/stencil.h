#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "common/grid/stencil_slots.h"

namespace burnish {

/// Rows that slots cannot describe: around the corner cells of several sheets lie in one place, or
/// a tie pulls at it. There are few of them, and none at the finest depth. Each entry is a sum of
/// numbers of cells and ties (cell_shares.h), listed here.
struct IrregularRows {
  std::vector<int32_t> corner;        ///< rising
  std::vector<int64_t> sum_start;     ///< corners + 1, into source_start: a row's sums are its
                                      ///< entries as the stencil stores them, then its row sum
  std::vector<int64_t> source_start;  ///< sums + 1, into source
  std::vector<int32_t> source;        ///< see number_of_cell() and number_of_tie()

  int32_t count() const { return static_cast<int32_t>(corner.size()); }
};

/// Cells with such a corner: where their pairs of corners stand.
struct IrregularCells {
  std::vector<int32_t> cell;                    ///< rising
  std::vector<std::array<uint16_t, 28>> entry;  ///< of pair (a, b), a < b, by pair_index(): its
                                                ///< number among the entries of corner a's row

  int32_t count() const { return static_cast<int32_t>(cell.size()); }
};

/// Where the columns of a stencil stand in a tile: the corners of kRows rows, and behind them the
/// others that have an entry in one of the rows. A product that copies a vector's numbers there
/// first finds them all in the cache nearest to the processor, by indices of half the size.
struct RowTiles {
  static constexpr int32_t kRows = 512;
  static constexpr int32_t kWidthMax = 1 << 15;

  /// A row among those of its tile.
  struct Row {
    uint16_t place;   ///< of its corner
    uint16_t groups;  ///< of Stencil::kRowPadding entries
  };

  std::vector<Row> row;
  std::vector<uint16_t> twice_local;  ///< two times the place of each Stencil::column
  std::vector<int64_t> halo_start;    ///< tiles + 1, into `halo`
  std::vector<int32_t> halo;          ///< rising within a tile
  std::vector<uint8_t> is_wide;       ///< of each tile: wider than kWidthMax, and without halo or
                                      ///< places then, as irregular rows could have it
  int32_t width_max = 0;              ///< of the others, corners and halo

  int32_t count() const { return static_cast<int32_t>(is_wide.size()); }
};

/// Which corners have a matrix entry with which others, itself left out: the off-diagonal pattern
/// of every matrix of one depth, in compressed rows.
///
/// Among each kRowWindow corners the rows are stored by rising length, so that a loop over rows
/// seldom meets another length than before (a mispredicted end costs as much as a row), and each
/// is padded to a multiple of kRowPadding entries by the corner itself, whose entry is zero there.
struct Stencil {
  static constexpr int32_t kRowWindow = 256;
  static constexpr int kRowPadding = 4;

  std::vector<int32_t> corner_of_row;
  std::vector<int32_t> row_of_corner;
  std::vector<int64_t> row_start;  ///< rows + 1
  std::vector<int32_t> column;     ///< in slot order within a row, rising in an irregular one
  std::vector<uint32_t> mask;      ///< bit s of mask[I]: slot s of corner I is present; 0 for an
                                   ///< irregular row
  RowTiles tiles;
  IrregularRows irregular;
  IrregularCells irregular_cells;

  struct Row {
    int64_t begin, end;
  };
  /// The places of a corner's entries in `column`, padding left out.
  Row row(int32_t corner) const {
    const int32_t stored = row_of_corner[corner];
    const int64_t begin = row_start[stored];
    if (mask[corner] != 0) return {begin, begin + __builtin_popcount(mask[corner])};
    int64_t end = row_start[stored + 1];
    while (end > begin && column[end - 1] == corner) --end;
    return {begin, end};
  }
  /// Where slot s of corner I stands in `column`. Needs: the slot is present.
  int64_t position(int32_t corner, int slot) const {
    return row_start[row_of_corner[corner]] + __builtin_popcount(mask[corner] & ((1u << slot) - 1));
  }
};

/// Two cells of a coarse depth that are coupled beyond the corners that they share: finer down,
/// sheets of both met in corners without hanging together there. Bit v of first_corners: corner v
/// of the first cell has a part in it.
struct CellTie {
  int32_t first, second;  ///< first < second
  uint8_t first_corners, second_corners;
};

/// A depth's numbers: 36 of each cell (28 pairs by pair_index(), then eight row sums), then 64 of
/// each tie (by corners of its first cell, then of its second). The finest depth has none, but
/// there the sheets of PreparedMesh have 64 each, by the cell's corners both times.
inline constexpr int kNumbersPerCell = 36;
inline constexpr int kNumbersPerTie = 64;
constexpr int32_t number_of_cell(int32_t cell, int number) {
  return kNumbersPerCell * cell + number;
}
constexpr int32_t number_of_tie(int32_t cells, int32_t tie, int first_corner, int second_corner) {
  return kNumbersPerCell * cells + kNumbersPerTie * tie + 8 * first_corner + second_corner;
}

static_assert(RowTiles::kRows % Stencil::kRowWindow == 0);

/// Tiles of rows whose columns are there, none wider than `width_max`.
RowTiles make_row_tiles(const Stencil& stencil, int32_t width_max = RowTiles::kWidthMax);

/// Corners are neighbours that share a cell or are tied.
Stencil make_stencil(const SparseGrid& grid, std::span<const CellTie> ties);

}  // namespace burnish
