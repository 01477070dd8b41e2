#pragma once

#include "server/solver/cpu/assembly/combined_cells.h"

namespace burnish::cpu {

/// Writes a cell's numbers as a tie has them.
void write_square(const CellMatrix& cell, double* square);

/// Adds a coarse depth's shares of the finer one's numbers to its cells, and makes its ties of
/// them.
void add_shares(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                const CombinedCells& fine_cells, CombinedCells& coarse_cells);

}  // namespace burnish::cpu
