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

/// The diagonal below which corners of a depth are pinned, and the sample of diagonals that it
/// comes from.
struct Pinning {
  static constexpr int kSamples = 64;
  float below;
  float sample[kSamples];
};

/// Makes the depth's matrix and inverse diagonal from its cells, or the listed blocks of rows.
/// Unless `probe` is null, r becomes the product with it. Needs: the numbers around these rows; for
/// listed ones, the pinning as the last call left it. Corners of other rows stay pinned or free.
/// Source: section 5.2.
void assemble(Stream& stream, const CellSquares<double>& cells, const Depth& depth,
              const BesideMatrix& beside, const float4* probe, Pinning* pinning,
              const BlockList& listed);

}  // namespace burnish::cuda
