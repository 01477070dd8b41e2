#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cuda/smoothers/spectrum.h"

// A depth's irregular rows (stencil.h), whose entries are sums of listed numbers. Kernels for all
// rows skip them or write zeros. If a depth has irregular rows, these functions run before or
// after. `listed`: the blocks of rows or of cells to do, or all.

namespace burnish::cuda {

/// Call after the other rows of S. Does the work of assemble() (assembly.h) with the numbers of
/// cells and ties.
void assemble_irregular_rows(Stream& stream, const CellSquares<double>& cells, const Depth& depth,
                             const float4* probe, const float* pinned_below,
                             const BlockList& listed);

/// Call after the other cells. Does the work of invert_cells() (cell_inverse.h).
void invert_irregular_cells(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                            float regularisation, const BlockList& listed);

/// Call before the other rows of M⁻¹. Does the work of assemble_inverse() (cell_inverse.h). Puts
/// the products with power.product into `next`; that iteration continues from them.
void assemble_irregular_inverse(Stream& stream, const Depth& depth,
                                const CellSquares<float>& inverses, const Matrix& inverse,
                                const PowerStep& power, float4* next, const BlockList& listed);

}  // namespace burnish::cuda
