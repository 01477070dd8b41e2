#pragma once

#include "common/grid/stencil_slots.h"
#include "server/solver/cuda/device/kernel.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cuda {

/// A row of the stencil: the sum over the corner's cells, always in the same order.
template <typename Real>
struct GatheredRow {
  Real by_slot[kSlots];
  Real own;
  /// The row sum less the other entries. In double: at corners of little weight the other entries
  /// may be much larger than it. The cycle would not converge with float32's remainder.
  double diagonal;
};

/// Returns the cells of a corner; no cells for corner -1.
__device__ inline Eight cells_around(const Topology& topology, int32_t corner) {
  if (corner >= 0) return topology.cells_of_corner[corner];
  return {-1, -1, -1, -1, -1, -1, -1, -1};
}

/// Returns whether a corner has cells by side; a corner of an irregular row has none.
__device__ inline bool is_regular(const Eight& cells) {
  int all = cells.at[0];  // negative while all are negative
#pragma unroll
  for (int a = 1; a < 8; ++a) all &= cells.at[a];
  return all >= 0;
}

// A missing cell counts as the first one, times zero, so its loads need not wait for a branch.
template <typename Real>
__device__ GatheredRow<Real> gather_row(const CellSquares<Real>& cells, const Eight& cells_here) {
  GatheredRow<Real> row = {};
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    const bool is_there = cells_here.at[a] >= 0;
    const int32_t cell = is_there ? cells_here.at[a] : 0;
    const Real own = own_of(cells, cell, a);
    row.own += is_there ? own : 0;
    double diagonal = own;
#pragma unroll
    for (int b = 0; b < 8; ++b) {
      if (b == a) continue;
      const Real pair = pair_of(cells, cell, pair_index(a, b));
      row.by_slot[slot_between(a, b)] += is_there ? pair : 0;
      diagonal -= pair;
    }
    row.diagonal += is_there ? diagonal : 0;
  }
  return row;
}

/// A block's room for the rows that it stores.
struct RowRoom {
  float by_slot[kSlots][kThreads];
};

/// Calls store(k, value, local) for the present slots of a row: k is the entry's place, `local` its
/// column's place in the group's tile, and value is value_of(number of the slot). Then stores zeros
/// up to the end of the slice, because a partly written sector of memory is read first. The row
/// goes through shared memory, so that all rows of a slice store their first entries, then their
/// second.
template <typename Real, typename ValueOf, typename Store>
__device__ void store_row(const Rows& rows, int32_t corner, const GatheredRow<Real>& row,
                          RowRoom& room, ValueOf&& value_of, Store&& store) {
#pragma unroll
  for (int slot = 0; slot < kSlots; ++slot)
    room.by_slot[slot][threadIdx.x] = value_of(row.by_slot[slot]);
  const int64_t begin = row_begin(rows, corner);
  const auto longest = static_cast<int>(
      (rows.slice_start[corner / kSliceRows + 1] - rows.slice_start[corner / kSliceRows]) /
      kSliceRows);
  uint32_t mask = rows.mask[corner];
  uint16_t local[kSlots - 1];  // loaded at once: single loads would take most of the time
#pragma unroll
  for (int j = 0; j < kSlots - 1; ++j)
    local[j] = j < longest ? rows.local[begin + kSliceRows * j] : 0;
#pragma unroll
  for (int j = 0; j < kSlots - 1; ++j, mask &= mask - 1)
    if (j < longest) {
      const int slot = mask != 0 ? __ffs(static_cast<int>(mask)) - 1 : kSelfSlot;  // that is 0
      store(begin + kSliceRows * j, room.by_slot[slot][threadIdx.x], uint32_t{local[j]});
    }
}

}  // namespace burnish::cuda
