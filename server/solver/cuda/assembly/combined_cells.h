#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// A session's metric, and the outputs that are kept of it.
struct Metric {
  const AlphaSource* alpha;
  const Curvature* curvature;  ///< per cell
  double scale;                ///< from α to grid units
  float* anisotropy;           ///< out: the largest ratio of α1 to α2, or α2 to α1, in a cell
  CellGradients gradients;     ///< out, unless its numbers are null
};

/// Does *to = alpha for kernels of a graph: a copy would take ten times as long to start.
void tell_alpha(Stream& stream, const AlphaSource& alpha, AlphaSource* to);

/// Makes the combined integrals of the finest depth.
void combine_integrals(Stream& stream, const Integrals& integrals, const Metric& metric,
                       const CellSquares<double>& combined);

/// Does the same with sheets, whose numbers stand after the cells'. Also makes the numbers of the
/// next coarser depth, in double too: a corner that the surface hardly reaches has far less
/// diagonal than float32 leaves of its row where mass outweighs stiffness (held rims and regions).
/// add_shares() adds the shares beyond the children's. `listed`: makes the children of these
/// blocks, all sheets, and all cells that are no child.
void combine_integrals(Stream& stream, const Integrals& integrals, const SheetIntegrals& sheets,
                       const Metric& metric, const CellSquares<double>& combined,
                       const Topology& fine, const Topology& coarse,
                       const CellSquares<double>& coarse_cells, const BlockList& listed);

/// Raises the metric's anisotropy to that of all cells, as a combination of all cells would.
void find_anisotropy(Stream& stream, const Metric& metric, int64_t cells);

/// Makes the combined integrals of the coarse depth from the fine depth's: Σ over children of Pᵀ K
/// P, and the depth's shares; in all blocks of the coarse depth's parts, or in the listed ones.
void down_sample(Stream& stream, const Topology& fine, const Topology& coarse,
                 const CellSquares<double>& fine_cells, const CellSquares<double>& coarse_cells,
                 const BlockList& listed);

}  // namespace burnish::cuda
