#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "common/grid/stencil_slots.h"
#include "server/solver/hierarchy/cell_matrix.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cpu {

/// The cells whose numbers make up the stored rows of a stencil, as plain pointers.
struct RowSources {
  const int32_t* corner;  ///< corner of a row
  const int64_t* start;
  const uint32_t* mask;                               ///< per corner
  const std::array<int32_t, kCornersPerCell>* cells;  ///< around a corner

  int32_t last;  ///< row
  const int32_t* row_of_corner;
  const int32_t* only;  ///< corners whose rows are summed; null: all

  /// Shapes: `only` corners in any order.
  RowSources(const HierarchyDepth& topology, std::span<const int32_t> only_corners)
      : RowSources(topology) {
    only = only_corners.data();
  }
  explicit RowSources(const HierarchyDepth& topology)
      : corner(topology.stencil.corner_of_row.data()),
        start(topology.stencil.row_start.data()),
        mask(topology.stencil.mask.data()),
        cells(topology.grid.cells_of_corner.data()),
        last(topology.grid.corner_count() - 1),
        row_of_corner(topology.stencil.row_of_corner.data()),
        only(nullptr) {}

  /// Returns the i-th row to sum.
  int32_t stored(int32_t i) const { return only == nullptr ? i : row_of_corner[only[i]]; }
};

/// A row of the stencil, summed from the symmetric 8×8 matrices of the cells around its corner.
template <typename T>
struct GatheredRow {
  /// The entries in their stored form: present slots in order, then zeros.
  alignas(64) T entry[kSlots + 5] = {};
  T off_diagonal = 0;  ///< the sum of the entries
  T own = 0;           ///< sum of the cells' own numbers of this corner
};

/// Prefetches the sources of rows further on. Cells come nearly in the order of rows, but too
/// irregularly for a processor to predict.
template <typename T>
[[gnu::always_inline]] inline void prefetch_sources(const RowSources& sources, const T* cells,
                                                    int32_t stored) {
  constexpr int32_t kRowsAhead = 32, kCellsAhead = 24;
  const int32_t later = sources.corner[std::min(stored + kRowsAhead, sources.last)];
  __builtin_prefetch(&sources.cells[later]);
  const auto& around = sources.cells[sources.corner[stored]];
  const int32_t newest = *std::max_element(around.begin(), around.end());
  const char* ahead = reinterpret_cast<const char*>(cells) +
                      (int64_t{newest} + kCellsAhead) * kNumbersPerCell * sizeof(T);
  for (size_t i = 0; i < kNumbersPerCell * sizeof(T); i += 64) __builtin_prefetch(ahead + i);
}

/// Gathers one stored row, which is not irregular. It has no branches, because rows differ too much
/// for a processor to predict: a missing cell adds zeros, and each entry is written before it is
/// known to be present. Shapes: `cells` has kNumbersPerCell numbers per cell: 28 pairs, then eight
/// own numbers, one per corner.
template <typename T>
[[gnu::always_inline]] inline GatheredRow<T> gather_row(const RowSources& sources, const T* cells,
                                                        int32_t stored) {
  static constexpr T kNoCell[kNumbersPerCell] = {};
  const int32_t corner = sources.corner[stored];
  const auto& around = sources.cells[corner];
  prefetch_sources(sources, cells, stored);
  GatheredRow<T> row;
  T by_slot[kSlots] = {};
#pragma GCC unroll 8
  for (int a = 0; a < kCornersPerCell; ++a) {
    const T* cell = around[a] == kNone ? kNoCell : cells + int64_t{around[a]} * kNumbersPerCell;
    row.own += cell[kPairsPerCell + a];
#pragma GCC unroll 8
    for (int b = 0; b < kCornersPerCell; ++b)
      if (b != a) by_slot[slot_between(a, b)] += cell[pair_index(a, b)];
  }
  const uint32_t mask = sources.mask[corner];
  int next = 0;
#pragma GCC unroll 27
  for (int s = 0; s < kSlots; ++s) {
    row.off_diagonal += by_slot[s];
    row.entry[next] = by_slot[s];
    next += static_cast<int>(mask >> s & 1);
  }
  return row;
}

/// Writes a gathered row to its place among the stored entries.
template <typename T, typename Entry>
[[gnu::always_inline]] inline void store_row(const RowSources& sources, int32_t stored,
                                             const GatheredRow<T>& row, Entry* entries) {
  constexpr int kGroup = Stencil::kRowPadding;
  Entry* to = entries + sources.start[stored];
  const int64_t length = sources.start[stored + 1] - sources.start[stored];
  for (int64_t k = 0; k < length; k += kGroup)
#pragma GCC unroll 4
    for (int64_t i = k; i < k + kGroup; ++i) to[i] = static_cast<Entry>(row.entry[i]);
}

}  // namespace burnish::cpu
