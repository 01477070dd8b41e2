#pragma once

#include <algorithm>

#include "server/solver/stencil.h"

namespace burnish {

/// The columns of irregular rows, one row after the other.
struct IrregularColumns {
  std::vector<int64_t> start;  ///< rows + 1
  std::vector<int32_t> column;

  int32_t length(int32_t row) const { return static_cast<int32_t>(start[row + 1] - start[row]); }
  /// Copies a corner's columns; returns the end of what it wrote.
  int32_t* copy_row(const IrregularRows& rows, int32_t corner, int32_t* to) const {
    const auto i = std::ranges::lower_bound(rows.corner, corner) - rows.corner.begin();
    return std::copy(column.begin() + start[i], column.begin() + start[i + 1], to);
  }
};

/// The rows of the corners with mask 0: their columns, and what their entries are sums of.
IrregularRows find_irregular_rows(const SparseGrid& grid, std::span<const CellTie> ties,
                                  std::span<const uint32_t> mask, IrregularColumns& columns);

/// The cells that have such a corner. Needs: all of the stencil but these.
IrregularCells find_irregular_cells(const SparseGrid& grid, const Stencil& stencil);

}  // namespace burnish
