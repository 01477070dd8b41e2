#pragma once

#include <span>

#include "server/fields/fields_view.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/cpu/scratch.h"
#include "server/solver/hierarchy/cell_matrix.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cpu {

/// The numbers of a depth's cells and ties (stencil.h), combined for one metric.
class CombinedCells {
 public:
  explicit CombinedCells(const HierarchyDepth& depth)
      : cells_((depth.number_count() + kNumbersPerCell - 1) / kNumbersPerCell) {}

  CellMatrix& operator[](size_t cell) { return cells_[cell]; }
  const CellMatrix& operator[](size_t cell) const { return cells_[cell]; }
  double* numbers() { return cells_[0].pair.data(); }
  const double* numbers() const { return cells_[0].pair.data(); }

 private:
  static_assert(sizeof(CellMatrix) == kNumbersPerCell * sizeof(double));
  Scratch<CellMatrix> cells_;
};

/// α1 and α2 of every cell of the finest depth, and what is held. Units: grid, once multiplied by
/// `scale`.
struct Metric {
  std::span<const float> alpha1, alpha2;
  double scale;
  LineView held;
};

/// Combines the numbers of the finest depth, and of the one above it if there is one. Restricts
/// them in the same pass.
void combine_cells(const PreparedMesh& prepared, const Metric& metric, CombinedCells& cells);
CombinedCells combine_and_down_sample(const PreparedMesh& prepared, const Metric& metric,
                                      const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                      CombinedCells& fine_cells);

/// Makes the numbers of the depth above: Σ Pᵀ K P over its cells' children, and over all shares.
CombinedCells down_sample(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                          const CombinedCells& fine_cells);

/// Do the same for some parts of a depth alone (changed_parts.h). Need: the numbers of all their
/// sources.
void combine_parts(const PreparedMesh& prepared, const Metric& metric, const HierarchyDepth& finest,
                   std::span<const int32_t> parts, CombinedCells& cells);
void down_sample_parts(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                       std::span<const int32_t> parts, const CombinedCells& fine_cells,
                       CombinedCells& coarse_cells);

}  // namespace burnish::cpu
