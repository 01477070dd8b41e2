#pragma once

#include <span>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Combined integrals of the finest depth, one per cell. Units: user α.
std::vector<CellMatrix> combine_integrals(const PreparedMesh& prepared,
                                          std::span<const float> alpha1,
                                          std::span<const float> alpha2);

/// Combined integrals of the coarse depth from those of the fine one: Σ over children of Pᵀ K P.
std::vector<CellMatrix> down_sample(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                    std::span<const CellMatrix> fine_cells);

/// The depth's matrix and inverse diagonal from its cells, and the same in double if `exact` is
/// given. Source: section 5.2.
void assemble(std::span<const CellMatrix> cells, CpuDepth& depth, ExactMatrix* exact = nullptr);

/// Sums per-cell matrices into rows of the stencil: row(corner, entries by slot, sum of own).
/// `pair_of(cell)` and `own_of(cell)` give a cell's packed pairs and its eight own numbers.
template <typename PairOf, typename OwnOf, typename Row>
void gather_rows(const HierarchyDepth& topology, PairOf&& pair_of, OwnOf&& own_of, Row&& row) {
  const int32_t n = topology.grid.corner_count();
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < n; ++corner) {
    double by_slot[kSlots] = {};
    double own = 0;
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t cell = topology.grid.cells_of_corner[corner][a];
      if (cell == kNone) continue;
      const auto& pair = pair_of(cell);
      own += own_of(cell)[a];
      for (int b = 0; b < kCornersPerCell; ++b)
        if (b != a) by_slot[slot_between(a, b)] += pair[pair_index(a, b)];
    }
    row(corner, by_slot, own);
  }
}

/// Calls store(k, value) for the present slots of a row, k being the entry's place.
template <typename Store>
void store_row(const Stencil& stencil, int32_t corner, const double* by_slot, Store&& store) {
  int64_t k = stencil.row_start[corner];
  for (uint32_t left = stencil.mask[corner]; left != 0; left &= left - 1, ++k)
    store(k, by_slot[__builtin_ctz(left)]);
}

}  // namespace burnish::cpu
