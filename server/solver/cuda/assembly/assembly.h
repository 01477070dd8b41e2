#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// What the finest depth's rows leave beside S: their sums, and what b has per slider where nobody
/// has painted. Null where it is not wanted.
struct BesideMatrix {
  double* row_sum = nullptr;
  CellGradients gradients = {};
  Double3* per_slider = nullptr;
};

/// The depth's matrix and inverse diagonal from its cells, and in r the product with `probe` unless
/// that is null. `pinned_below` is one number of working memory. Source: section 5.2.
template <typename Real>
void assemble(Stream& stream, const CellSquares<Real>& cells, const Depth& depth,
              const BesideMatrix& beside, const float4* probe, float* pinned_below);

}  // namespace burnish::cuda
