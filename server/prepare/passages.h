#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "common/grid/stencil_slots.h"
#include "server/prepare/clip.h"

namespace burnish {

/// A bit for each neighbour of a cell: bit s is the one at stencil slot s. Bit kSelfSlot is 0.
using Passages = uint32_t;
inline constexpr Passages kAllPassages = (Passages{1} << kSlots) - 1 - (Passages{1} << kSelfSlot);

inline Vec3i offset_of_slot(int slot) {
  return {slot % 3 - 1, slot / 3 % 3 - 1, slot / 9 - 1};
}

/// The columns of one triangle around one of them, found by going through all in order: three
/// places in the list move along with it, so that all together cost no more than the list is long.
class ColumnsAround {
 public:
  /// Needs: columns as of find_columns().
  explicit ColumnsAround(std::span<const CellColumn> columns) : columns_(columns) {}

  /// Needs: `column` is one of the columns, and none before the last one asked for.
  void move_to(const CellColumn& column);

  /// From cell (i, j, k) of that column to the triangle's other cells.
  Passages passages(int k) const;

 private:
  struct Near {
    SlabRange k;
    int lowest_slot;  // of the cell below
  };

  std::span<const CellColumn> columns_;
  std::array<size_t, 3> row_ = {};  // the first column near in rows i - 1, i, i + 1
  std::array<Near, 9> near_;
  int near_count_ = 0;
};

/// Calls visit(cell, passages) once for each cell of one triangle.
/// Needs: columns as of find_columns(). Cost: proportional to the number of cells.
template <typename Visit>
void for_each_cell_with_passages(std::span<const CellColumn> columns, Visit&& visit) {
  ColumnsAround around(columns);
  for (const CellColumn& column : columns) {
    around.move_to(column);
    for (int k = column.k.first; k <= column.k.last; ++k)
      visit(Vec3i(column.i, column.j, k), around.passages(k));
  }
}

}  // namespace burnish
