#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/hierarchy/coarse_grid.h"
#include "server/solver/hierarchy/sheets/sheet_corners.h"

namespace burnish {

/// Prolongation P and restriction Pᵀ between a depth and the one above (coarser); trilinear.
struct DepthTransfer {
  /// Corners of the finest depth in which several sheets meet. Each is the mean of the values from
  /// its sheets' cells, weighed by their energy. Corners of small components alone have no value.
  struct SharedCorners {
    std::vector<int32_t> corner;         ///< rising
    std::vector<int32_t> start;          ///< corners + 1
    std::vector<int32_t> coarse_corner;  ///< rising within a corner
    std::vector<float> weight;

    int32_t count() const { return static_cast<int32_t>(corner.size()); }
  };
  std::vector<FromCell> prolongation;  ///< one per fine corner; a shared corner has no cell
  SharedCorners shared;
  std::vector<int64_t> restriction_start;   ///< coarse corners + 1
  std::vector<int32_t> restriction_corner;  ///< the fine corners that a coarse corner gathers
  std::vector<float> restriction_weight;    ///< 1, 1/2, 1/4 or 1/8 unless the fine corner is shared

  /// Returns whether a fine corner is shared, so that it does not follow from one cell.
  bool is_shared(int32_t corner) const { return prolongation[corner].cell == kNone; }
};

/// Makes the restriction that belongs to the prolongation of the first `fine_corners`.
void make_restriction(const SparseGrid& coarse, int32_t fine_corners, DepthTransfer& transfer);

DepthTransfer make_transfer(const CoarseGrid& coarse);
/// From the finest depth; the coarse grid keeps its sheets apart.
DepthTransfer make_transfer(const CoarseGrid& coarse, const SheetCorners& sheets,
                            int32_t corner_count);

}  // namespace burnish
