#pragma once

#include "server/solver/cuda/device_memory.h"
#include "server/solver/cuda/views.h"

namespace burnish::cuda {

/// Combined integrals of the finest depth, and the largest ratio of α1 and α2, either way round, of
/// any cell. Units: α in grid units × `scale`.
void combine_integrals(Stream& stream, const Integrals& integrals, const float* alpha1,
                       const float* alpha2, double scale, const CellSquares<double>& combined,
                       const DeviceArray<float>& anisotropy);

/// Combined integrals of the coarse depth from those of the fine one: Σ over children of Pᵀ K P.
void down_sample(Stream& stream, const Topology& fine, const Topology& coarse,
                 const CellSquares<double>& fine_cells, const CellSquares<double>& coarse_cells);

/// The depth's matrix and inverse diagonal from its cells, and its row sums unless null.
/// `pinned_below` is one number of working memory. Source: section 5.2.
void assemble(Stream& stream, const CellSquares<double>& cells, const Depth& depth, double* row_sum,
              float* pinned_below);

}  // namespace burnish::cuda
