#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cuda/smoothers/spectrum.h"

// A depth's irregular rows (stencil.h), whose entries are sums of listed numbers. Kernels for all
// rows leave them out or write zeros; these come before or after, where there are any.

namespace burnish::cuda {

/// After the other rows of S: as assemble() (assembly.h), from the numbers of cells and ties.
void assemble_irregular_rows(Stream& stream, const CellSquares<float>& cells, const Depth& depth,
                             const float4* probe, const float* pinned_below);

/// After the other cells: as invert_cells() (cell_inverse.h).
void invert_irregular_cells(Stream& stream, const Depth& depth, const CellSquares<float>& inverses);

/// Before the other rows of M⁻¹: as assemble_inverse() (cell_inverse.h), and in `next` the products
/// with power.product, which that iteration goes on from.
void assemble_irregular_inverse(Stream& stream, const Depth& depth,
                                const CellSquares<float>& inverses, const Matrix& inverse,
                                const PowerStep& power, float4* next);

}  // namespace burnish::cuda
