#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Cells that stay where they are, and a band around them in which edits fade out (docs/solver.md,
/// "Controls").
struct Hold {
  std::vector<int32_t> cells;  ///< cells that stay, rising
  std::vector<float> weight;   ///< per cell: 1 in the cells that stay, 0 beyond the band
  uint64_t byte_count() const { return cells.size() * 4 + weight.size() * 4; }
};

inline constexpr int kHoldBandCells = 1;
/// Held cells have at most this many times their α: the cycle is still good at such contrasts.
inline constexpr double kHoldContrastMax = 1000;

/// Makes the band around some cells. Needs: rising cells.
Hold make_hold(const PreparedMesh& prepared, std::vector<int32_t> cells);

/// Returns the α of a cell that is held by `weight`. Units: as `alpha`. `alpha_of_grid` is the α at
/// which a wave of the grid's size is halved.
double held_alpha(double alpha, double weight, double alpha_of_grid);

}  // namespace burnish
