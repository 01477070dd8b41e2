#pragma once

#include "server/solver/cell_matrix.h"
#include "server/solver/cuda/kernel.h"
#include "server/solver/stencil_slots.h"

namespace burnish::cuda {

/// A row of the stencil: the sum over the corner's cells, always in the same order.
template <typename Real>
struct GatheredRow {
  Real by_slot[kSlots];
  Real own;
};

// A cell that is not there counts as the first, times zero: its loads need not wait for a branch.
template <typename Real>
__device__ GatheredRow<Real> gather_row(const Topology& topology, const CellSquares<Real>& cells,
                                        int32_t corner) {
  GatheredRow<Real> row = {};
  const Eight cells_here = topology.cells_of_corner[corner];
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = cells_here.at[a] >= 0;
    const int32_t cell = is_there ? cells_here.at[a] : 0;
    const Real own = own_of(cells, cell, a);
    row.own += is_there ? own : 0;
#pragma unroll
    for (int b = 0; b < 8; ++b) {
      if (b == a) continue;
      const Real pair = pair_of(cells, cell, pair_index(a, b));
      row.by_slot[slot_between(a, b)] += is_there ? pair : 0;
    }
  }
  return row;
}

/// Calls store(k, value, local) for the present slots of a row, k being the entry's place and
/// `local` that of its column in the group's tile; then with zeros to the end of its slice, because
/// a sector of memory that is written in part is read first. The row goes through shared memory, so
/// that all rows of a slice store their first entries, then their second.
template <typename Real, typename Store>
__device__ void store_row(const Rows& rows, int32_t corner, const GatheredRow<Real>& row,
                          Store&& store) {
  __shared__ Real by_slot[kSlots][kThreads];
#pragma unroll
  for (int slot = 0; slot < kSlots; ++slot) by_slot[slot][threadIdx.x] = row.by_slot[slot];
  const int64_t begin = row_begin(rows, corner);
  const auto longest = static_cast<int>(
      (rows.slice_start[corner / kSliceRows + 1] - rows.slice_start[corner / kSliceRows]) /
      kSliceRows);
  uint32_t mask = rows.mask[corner];
  uint16_t local[kSlots - 1];  // all at once: one after the other they would take most of the time
#pragma unroll
  for (int j = 0; j < kSlots - 1; ++j)
    local[j] = j < longest ? rows.local[begin + kSliceRows * j] : 0;
#pragma unroll
  for (int j = 0; j < kSlots - 1; ++j, mask &= mask - 1)
    if (j < longest) {
      const int slot = mask != 0 ? __ffs(static_cast<int>(mask)) - 1 : kSelfSlot;  // that is 0
      store(begin + kSliceRows * j, by_slot[slot][threadIdx.x], uint32_t{local[j]});
    }
}

}  // namespace burnish::cuda
