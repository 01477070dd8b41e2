#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A session's metric and what is kept of it.
struct Metric {
  const AlphaSource* alpha;
  const Curvature* curvature;  ///< of every cell
  double scale;                ///< of α to grid units
  float* anisotropy;        ///< out: the largest ratio of α1 and α2, either way round, of a cell
  CellGradients gradients;  ///< out, unless its numbers are null
};

/// *to = alpha, for kernels of a graph: a copy would take ten times as long to start.
void tell_alpha(Stream& stream, const AlphaSource& alpha, AlphaSource* to);

/// Combined integrals of the finest depth.
void combine_integrals(Stream& stream, const Integrals& integrals, const Metric& metric,
                       const CellSquares<double>& combined);

/// The same with sheets, whose numbers stand behind those of the cells, and those of the next
/// coarser depth, which for coarse depths need float32 only: they precondition. What they take
/// beyond their children's is left to add_shares().
void combine_integrals(Stream& stream, const Integrals& integrals, const SheetIntegrals& sheets,
                       const Metric& metric, const CellSquares<double>& combined,
                       const Topology& fine, const Topology& coarse,
                       const CellSquares<float>& coarse_cells);

/// Combined integrals of the coarse depth from those of the fine one: Σ over children of Pᵀ K P,
/// and what else the depth's shares say.
void down_sample(Stream& stream, const Topology& fine, const Topology& coarse,
                 const CellSquares<float>& fine_cells, const CellSquares<float>& coarse_cells);

}  // namespace burnish::cuda
