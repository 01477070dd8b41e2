#pragma once

#include "server/solver/cpu/assembly/combined_cells.h"

namespace burnish::cpu {

/// Writes a cell's numbers in the layout of a tie.
void write_square(const CellMatrix& cell, double* square);

/// Adds the shares of the finer depth's numbers to the cells of a coarse depth, and makes its ties
/// of them.
void add_shares(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                const CombinedCells& fine_cells, CombinedCells& coarse_cells);
/// Does the same for one cell or tie, if it has shares.
void add_shares(const HierarchyDepth& fine, const HierarchyDepth& coarse, int32_t part,
                const CombinedCells& fine_cells, CombinedCells& coarse_cells);

}  // namespace burnish::cpu
