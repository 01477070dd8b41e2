#pragma once

#include "server/solver/cuda/stream.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// The depth's matrix and inverse diagonal from its cells, its row sums unless null, and in r the
/// product with `probe` unless that is null. `pinned_below` is one number of working memory.
/// Source: section 5.2.
template <typename Real>
void assemble(Stream& stream, const CellSquares<Real>& cells, const Depth& depth, double* row_sum,
              const float4* probe, float* pinned_below);

}  // namespace burnish::cuda
