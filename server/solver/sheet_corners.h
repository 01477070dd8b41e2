#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The corners of the finest depth, once for each sheet of surface that meets there. Two cells
/// around a corner are of one sheet when passages lead from one to the other around it.
///
/// A corner's first sheet has the corner's number, the others have numbers beyond all corners.
struct SheetCorners {
  int32_t count = 0;
  std::vector<std::array<int32_t, kCornersPerCell>> of_cell;

  /// The corners with several sheets, rising, and these: [start[i], start[i + 1]).
  std::vector<int32_t> shared;
  std::vector<int32_t> start;
  std::vector<int32_t> sheet;
  std::vector<float> weight;  ///< a sheet's share of the corner's energy ℓ¹ + ℓ²; sum 1
};

SheetCorners find_sheet_corners(const PreparedMesh& prepared, const SparseGrid& finest);

}  // namespace burnish
