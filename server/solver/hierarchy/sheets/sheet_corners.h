#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The sheets of surface at the finest depth. A cell has one sheet, or one for each component of
/// the mesh that passes through it. Two sheets of neighbouring cells hang together if passages lead
/// from one to the other. A corner has one copy for all sheets around it that hang together there.
///
/// A corner's first copy has the corner's number. The other copies have numbers beyond all corners.
struct SheetCorners {
  // Every sheet, by cell.
  std::vector<int32_t> first_of_cell;  ///< cells + 1
  std::vector<GridKey> cell;
  std::vector<int32_t> source;  ///< the cell, or cells + the index in PreparedMesh::sheets
  std::vector<std::array<int32_t, kCornersPerCell>> corners;  ///< copies

  int32_t copy_count = 0;
  // The corners with several copies, rising, and the copies: [start[i], start[i + 1]).
  std::vector<int32_t> shared;
  std::vector<int32_t> start;
  std::vector<int32_t> copy;
  std::vector<float> weight;  ///< a copy's part of the corner's energy ℓ¹ + ℓ²; the sum is 1

  bool has_several(int32_t of_cell) const {
    return first_of_cell[of_cell + 1] - first_of_cell[of_cell] > 1;
  }
};

SheetCorners find_sheet_corners(const PreparedMesh& prepared, const SparseGrid& finest);

/// Makes one sheet for each cell, and one copy of each corner.
SheetCorners one_sheet_per_cell(const SparseGrid& finest);

}  // namespace burnish
