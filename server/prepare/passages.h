#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/scratch_space.h"
#include "common/grid/morton.h"
#include "common/grid/stencil_slots.h"
#include "server/prepare/clip.h"

namespace burnish {

// Passages: the surface leads from a cell into a neighbour. Two cells of one triangle have a
// passage between them. So have the cells of two triangles that meet at an edge in a grid plane, as
// happens on each surface that is symmetric about the middle of its box. Neither triangle lies on
// both sides, but each touches the other's cells, with an edge or its whole area. A touch from one
// side proves nothing: where the triangle ends, another surface may lie across the plane. Such
// passages are in doubt until both sides are known.

/// A bit for each neighbour of a cell: bit s is the neighbour at stencil slot s. Bit kSelfSlot is
/// 0. Until close_one_sided_passages(), bit kSlots + a says that passages across axis a are in
/// doubt.
using Passages = uint32_t;
inline constexpr Passages kAllPassages = (Passages{1} << kSlots) - 1 - (Passages{1} << kSelfSlot);
inline constexpr Passages kInDoubt = Passages{7} << kSlots;

inline Vec3i offset_of_slot(int slot) {
  return {slot % 3 - 1, slot / 3 % 3 - 1, slot / 9 - 1};
}

/// Finds the columns around one of a list while it goes through all in order. Three places in the
/// list move along, so the total cost is linear in the length of the list.
class ColumnsAround {
 public:
  /// Needs: columns in the order of i, then j, each pair once.
  explicit ColumnsAround(std::span<const CellColumn> columns) : columns_(columns) {}

  /// Needs: columns in order, none before the last one.
  void move_to(const CellColumn& column);

  /// Returns the passages from cell (i, j, k) of that column to the cells of the list.
  Passages passages(int k) const;

 private:
  struct Near {
    SlabRange k;
    int lowest_slot;  // of the cell below
  };

  std::span<const CellColumn> columns_;
  std::array<size_t, 3> row_ = {};  // the first near column in rows i - 1, i, i + 1
  std::array<Near, 9> near_;
  int near_count_ = 0;
};

/// An edge of a triangle, and the cells that it meets or touches.
struct EdgeInPlane {
  unsigned axes;  ///< bit a: the edge lies in a grid plane across axis a
  std::vector<CellColumn> columns;
};

/// Returns the edges of a triangle that lie in a grid plane, mostly none. Leaves out an edge that
/// is only in the plane of the whole triangle. Units: grid, snapped to planes.
std::vector<EdgeInPlane> edges_in_planes(const std::array<Vec3d, 3>& triangle);

/// The passages of one triangle's cells, column by column.
class TrianglePassages {
 public:
  /// Needs: the columns of find_columns().
  TrianglePassages(const std::array<Vec3d, 3>& triangle, std::span<const CellColumn> columns);

  /// Needs: columns in order.
  void move_to(const CellColumn& column);

  /// Returns the passages of cell (i, j, k) of that column.
  Passages at(int k) const;

 private:
  ColumnsAround met_;
  Passages below_plane_;  // of each cell, if the whole triangle lies in a grid plane
  std::vector<EdgeInPlane> edges_;
  std::vector<ColumnsAround> touched_;  // per edge
};

/// Calls visit(cell, passages) once for each cell of a triangle with these columns.
/// Cost: proportional to the number of cells.
template <typename Visit>
void for_each_cell_with_passages(const std::array<Vec3d, 3>& triangle,
                                 std::span<const CellColumn> columns, Visit&& visit) {
  TrianglePassages passages(triangle, columns);
  for (const CellColumn& column : columns) {
    passages.move_to(column);
    for (int k = column.k.first; k <= column.k.last; ++k)
      visit(Vec3i(column.i, column.j, k), passages.at(k));
  }
}

/// Puts the neighbours of a cell that will be removed in doubt. Shapes: one entry of `passages` per
/// cell, cells strictly rising.
void doubt_passages_to(size_t cell, std::span<const MortonKey> cells, std::span<Passages> passages);

/// Closes doubtful passages that lead to no cell, or to a cell without the opposite passage.
/// Afterwards no cell is in doubt. A copy of the passages lies in `space` meanwhile.
void close_one_sided_passages(std::span<const MortonKey> cells, std::span<Passages> passages,
                              const ScratchSpace& space);

}  // namespace burnish
