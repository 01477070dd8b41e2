#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Two more results of the finest depth's rows beside S: their sums, and the change of b per slider
/// step without paint. Null if not wanted.
struct BesideMatrix {
  double* row_sum = nullptr;
  CellGradients gradients = {};
  Double3* per_slider = nullptr;
};

/// Makes the depth's matrix and inverse diagonal from its cells. Unless `probe` is null, r becomes
/// the product with it. `pinned_below` is one number of working memory. Source: section 5.2.
void assemble(Stream& stream, const CellSquares<double>& cells, const Depth& depth,
              const BesideMatrix& beside, const float4* probe, float* pinned_below);

}  // namespace burnish::cuda
