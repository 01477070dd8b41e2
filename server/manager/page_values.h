#pragma once

#include <span>

#include "common/grid/sparse_grid.h"
#include "common/service/page_values.h"

namespace burnish {

/// Returns the value of the cell of each vertex, rounded. A vertex whose cell is not in the grid
/// has the cell of make_page_evaluation(); one without any cell does not count, and has `low`.
/// Shapes: one value per cell of the grid. Needs: depth of the grid <= bits of the lattice.
PageValues page_values(const Page& page, int bits, const SparseGrid& grid,
                       std::span<const float> cell_values);

}  // namespace burnish
