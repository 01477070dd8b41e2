#include "server/fields/cell_index.h"

#include <algorithm>
#include <string>

#include "common/grid/morton.h"

namespace burnish {

Result<int32_t> index_of_cell(const PreparedMesh& prepared, const Vec3i& cell) {
  const auto text = [&] {
    return "cell " + std::to_string(cell.x()) + " " + std::to_string(cell.y()) + " " +
           std::to_string(cell.z());
  };
  const int side = prepared.frame.cells_per_side();
  if ((cell.array() < 0).any() || (cell.array() >= side).any())
    return invalid_argument(text() + " is outside the grid of 0.." + std::to_string(side - 1));
  const MortonKey key = morton_key(cell);
  const auto it = std::lower_bound(prepared.cells.begin(), prepared.cells.end(), key);
  if (it == prepared.cells.end() || *it != key)
    return invalid_argument(text() + " holds no surface at depth " +
                            std::to_string(prepared.frame.depth));
  return static_cast<int32_t>(it - prepared.cells.begin());
}

}  // namespace burnish
