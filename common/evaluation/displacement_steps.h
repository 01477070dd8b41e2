#pragma once

#include <algorithm>
#include <cstdint>

namespace burnish {

/// Frames carry displacements in steps of 1/256 cell.
inline constexpr double kStepsPerCell = 256;
/// Displacements beyond this are cut off: only corners that hardly weigh on a vertex have them.
inline constexpr double kDisplacementCellsMax = 1 << 20;

/// Rounds a displacement in cells to steps, half steps away from zero. Needs: finite `cells`.
inline int32_t to_steps(double cells) {
  const double cut = std::clamp(cells, -kDisplacementCellsMax, kDisplacementCellsMax);
  return static_cast<int32_t>(cut * kStepsPerCell + (cut < 0 ? -0.5 : 0.5));
}

}  // namespace burnish
