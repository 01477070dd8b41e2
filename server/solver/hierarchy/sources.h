#pragma once

#include <algorithm>
#include <cstdint>

#include "server/solver/hierarchy/hierarchy.h"

// Which numbers the rows of S and the numbers of coarse cells are sums of. A depth's parts are what
// has numbers: its cells, then its ties, or at the finest depth its sheets.

namespace burnish {

inline size_t part_count(const HierarchyDepth& depth) {
  return depth.grid.cells.size() + depth.ties.size() + depth.sheet_count;
}

inline int32_t part_of_number(const HierarchyDepth& depth, int32_t number) {
  const int32_t of_cells = kNumbersPerCell * depth.grid.cell_count();
  if (number < of_cells) return number / kNumbersPerCell;
  return depth.grid.cell_count() + (number - of_cells) / kNumbersPerTie;
}

/// Calls visit(part) for the parts that a corner's row sums.
template <typename Visit>
void visit_parts_of_row(const HierarchyDepth& depth, int32_t corner, Visit&& visit) {
  if (!depth.stencil.is_irregular(corner)) {
    for (const int32_t cell : depth.grid.cells_of_corner[corner])
      if (cell != kNone) visit(cell);
    return;
  }
  const IrregularRows& rows = depth.stencil.irregular;
  const auto i = std::ranges::lower_bound(rows.corner, corner) - rows.corner.begin();
  const int64_t end = rows.source_start[rows.sum_start[i + 1]];
  for (int64_t k = rows.source_start[rows.sum_start[i]]; k < end; ++k)
    visit(part_of_number(depth, rows.source[k]));
}

/// Calls visit(part of the finer depth) for the sources of a coarse part's numbers.
template <typename Visit>
void visit_sources(const HierarchyDepth& coarse, int32_t part, Visit&& visit) {
  if (part < coarse.grid.cell_count())
    for (const int32_t child : coarse.children[part]) visit(child);
  const CellShares& shares = coarse.shares;
  const auto i = std::ranges::lower_bound(shares.target, part) - shares.target.begin();
  if (i == std::ssize(shares.target) || shares.target[i] != part) return;
  for (int32_t k = shares.start[i]; k < shares.start[i + 1]; ++k) visit(shares.share[k].source);
}

}  // namespace burnish
