#pragma once

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// Sums per-cell matrices into rows of the stencil: row(corner, entries by slot, sum of own), in
/// the order in which rows are stored.
/// `pair(cell, p)` and `own(cell, a)` give a cell's packed pairs and its eight own numbers.
template <typename T, typename Pair, typename Own, typename Row>
void gather_rows(const HierarchyDepth& topology, Pair&& pair, Own&& own, Row&& row) {
  const int32_t n = topology.grid.corner_count();
#pragma omp parallel for schedule(static)
  for (int32_t stored = 0; stored < n; ++stored) {
    const int32_t corner = topology.stencil.corner_of_row[stored];
    T by_slot[kSlots] = {};
    T sum_of_own = 0;
    const auto& cells = topology.grid.cells_of_corner[corner];
#pragma GCC unroll 8
    for (int a = 0; a < kCornersPerCell; ++a) {
      if (cells[a] == kNone) continue;
      sum_of_own += own(cells[a], a);
#pragma GCC unroll 8
      for (int b = 0; b < kCornersPerCell; ++b)
        if (b != a) by_slot[slot_between(a, b)] += pair(cells[a], pair_index(a, b));
    }
    row(corner, by_slot, sum_of_own);
  }
}

/// Calls store(k, value) for the present slots of a row, k being the entry's place.
template <typename T, typename Store>
void store_row(const Stencil& stencil, int32_t corner, const T* by_slot, Store&& store) {
  int64_t k = stencil.row(corner).begin;
  for (uint32_t left = stencil.mask[corner]; left != 0; left &= left - 1, ++k)
    store(k, by_slot[__builtin_ctz(left)]);
}

}  // namespace burnish::cpu
