#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// Rows that slots cannot describe: around the corner, cells of several sheets lie in one place, or
/// a tie couples it. Such rows are few, and the finest depth has none. Each entry is a sum of
/// numbers of cells and ties (cell_shares.h), listed here.
struct IrregularRows {
  std::vector<int32_t> corner;     ///< rising
  std::vector<int64_t> sum_start;  ///< corners + 1, into source_start; a row's sums are its entries
                                   ///< in the stencil's order, then its row sum
  std::vector<int64_t> source_start;  ///< sums + 1, into source
  std::vector<int32_t> source;        ///< see number_of_cell() and number_of_tie()

  int32_t count() const { return static_cast<int32_t>(corner.size()); }
};

/// Cells with an irregular corner, and where their pairs of corners stand.
struct IrregularCells {
  std::vector<int32_t> cell;  ///< rising
  std::vector<std::array<uint16_t, kPairsPerCell>>
      entry;  ///< for pair (a, b), a < b, by pair_index(): its index among the entries of corner
              ///< a's row

  int32_t count() const { return static_cast<int32_t>(cell.size()); }
};

/// Two cells of a coarse depth that are coupled beyond the corners that they share. At a finer
/// depth, sheets of both met in corners without hanging together there. Bit v of first_corners:
/// corner v of the first cell takes part.
struct CellTie {
  int32_t first, second;  ///< first < second
  uint8_t first_corners, second_corners;
};

/// A depth's numbers: 36 per cell (28 pairs by pair_index(), then eight row sums), then 64 per tie
/// (by corners of its first cell, then of its second). The finest depth has no ties; there the
/// sheets of PreparedMesh have 64 each, both times by the cell's corners.
inline constexpr int kNumbersPerCell = 36;
inline constexpr int kNumbersPerTie = 64;
constexpr int32_t number_of_cell(int32_t cell, int number) {
  return kNumbersPerCell * cell + number;
}
constexpr int32_t number_of_tie(int32_t cells, int32_t tie, int first_corner, int second_corner) {
  return kNumbersPerCell * cells + kNumbersPerTie * tie + 8 * first_corner + second_corner;
}

/// The columns of irregular rows, one row after the other.
struct IrregularColumns {
  std::vector<int64_t> start;  ///< rows + 1
  std::vector<int32_t> column;

  int32_t length(int32_t row) const { return static_cast<int32_t>(start[row + 1] - start[row]); }
  /// Copies a corner's columns. Returns the end of the copy.
  int32_t* copy_row(const IrregularRows& rows, int32_t corner, int32_t* to) const {
    const auto i = std::ranges::lower_bound(rows.corner, corner) - rows.corner.begin();
    return std::copy(column.begin() + start[i], column.begin() + start[i + 1], to);
  }
};

/// Finds the rows of the corners with mask 0: their columns, and the summands of their entries.
IrregularRows find_irregular_rows(const SparseGrid& grid, std::span<const CellTie> ties,
                                  std::span<const uint32_t> mask, IrregularColumns& columns);

}  // namespace burnish
