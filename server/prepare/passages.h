#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/morton.h"
#include "common/grid/stencil_slots.h"
#include "server/prepare/clip.h"

namespace burnish {

// Where the surface goes on from a cell to its neighbours. Two cells of one triangle have a passage
// between them. So have the cells of two triangles that meet at an edge in a grid plane, as they do
// on whatever is symmetric about the middle of its box: neither triangle lies on both sides, but
// each touches the other's, with an edge or with all of itself. One that touches alone proves
// nothing: where it ends, something else may lie across the plane. Hence such passages are in doubt
// until both sides are known.

/// A bit for each neighbour of a cell: bit s is the one at stencil slot s. Bit kSelfSlot is 0.
/// Until close_one_sided_passages(), bit kSlots + a says that those across axis a are in doubt.
using Passages = uint32_t;
inline constexpr Passages kAllPassages = (Passages{1} << kSlots) - 1 - (Passages{1} << kSelfSlot);
inline constexpr Passages kInDoubt = Passages{7} << kSlots;

inline Vec3i offset_of_slot(int slot) {
  return {slot % 3 - 1, slot / 3 % 3 - 1, slot / 9 - 1};
}

/// Columns around one of a list, found by going through all in order: three places in the list
/// move along, so that all together cost no more than the list is long.
class ColumnsAround {
 public:
  /// Needs: columns in the order of i, then j, each pair once.
  explicit ColumnsAround(std::span<const CellColumn> columns) : columns_(columns) {}

  /// Needs: no column before the last one asked for.
  void move_to(const CellColumn& column);

  /// From cell (i, j, k) of that column to the cells of the list.
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

/// An edge of a triangle, and the cells that it meets or touches.
struct EdgeInPlane {
  unsigned axes;  ///< bit a: the edge lies in a grid plane across axis a
  std::vector<CellColumn> columns;
};

/// Those of a triangle, but for edges in no other grid plane than the whole triangle: none, mostly.
/// Units: grid, snapped to planes.
std::vector<EdgeInPlane> edges_in_planes(const std::array<Vec3d, 3>& triangle);

/// The passages of one triangle's cells, column by column.
class TrianglePassages {
 public:
  /// Needs: the columns of find_columns().
  TrianglePassages(const std::array<Vec3d, 3>& triangle, std::span<const CellColumn> columns);

  /// Needs: columns are asked for in their order.
  void move_to(const CellColumn& column);

  /// Of cell (i, j, k) of that column.
  Passages at(int k) const;

 private:
  ColumnsAround met_;
  Passages below_plane_;  // of each cell, where the whole triangle lies in a grid plane
  std::vector<EdgeInPlane> edges_;
  std::vector<ColumnsAround> touched_;  // by each edge
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

/// Puts the neighbours of a cell that is about to go in doubt.
/// Shapes: one entry of `passages` per cell, cells strictly rising.
void doubt_passages_to(size_t cell, std::span<const MortonKey> cells, std::span<Passages> passages);

/// Closes passages that lead to no cell or that its own passages do not return, where in doubt; no
/// cell is any more.
void close_one_sided_passages(std::span<const MortonKey> cells, std::span<Passages> passages);

}  // namespace burnish
