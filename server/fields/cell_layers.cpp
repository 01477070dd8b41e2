#include "server/fields/cell_layers.h"

#include <algorithm>
#include <utility>

#include "common/grid/sparse_grid.h"
#include "common/grid/stencil_slots.h"
#include "server/prepare/passages.h"

namespace burnish {

int32_t find_cell(const PreparedMesh& prepared, const Vec3i& cell) {
  const int side = prepared.frame.cells_per_side();
  if ((cell.array() < 0).any() || (cell.array() >= side).any()) return kNone;
  const MortonKey key = morton_key(cell);
  const auto found = std::lower_bound(prepared.cells.begin(), prepared.cells.end(), key);
  if (found == prepared.cells.end() || *found != key) return kNone;
  return static_cast<int32_t>(found - prepared.cells.begin());
}

std::vector<int32_t> neighbours_of(const PreparedMesh& prepared, int32_t cell) {
  std::vector<int32_t> neighbours;
  const Vec3i place = morton_point(prepared.cells[cell]);
  for (int slot = 0; slot < kSlots; ++slot) {
    if ((prepared.passages[cell] >> slot & 1) == 0) continue;
    const int32_t other = find_cell(prepared, place + offset_of_slot(slot));
    if (other != kNone) neighbours.push_back(other);
  }
  return neighbours;
}

std::vector<uint8_t> layers_from(const PreparedMesh& prepared, std::span<const int32_t> seeds,
                                 int far) {
  const auto beyond = static_cast<uint8_t>(far + 1);
  std::vector<uint8_t> layer(prepared.cells.size(), beyond);
  std::vector<int32_t> front(seeds.begin(), seeds.end()), next;
  for (const int32_t seed : front) layer[seed] = 0;
  for (uint8_t step = 1; step < beyond && !front.empty(); ++step) {
    for (const int32_t cell : front)
      for (const int32_t other : neighbours_of(prepared, cell)) {
        if (layer[other] <= step) continue;
        layer[other] = step;
        next.push_back(other);
      }
    front = std::move(next);
    next.clear();
  }
  return layer;
}

std::vector<uint8_t> cells_of_piece(const PreparedMesh& prepared, int32_t seed) {
  std::vector<uint8_t> is_of_piece(prepared.cells.size(), 0);
  std::vector<int32_t> front = {seed};
  is_of_piece[seed] = 1;
  while (!front.empty()) {
    const int32_t cell = front.back();
    front.pop_back();
    for (const int32_t other : neighbours_of(prepared, cell))
      if (std::exchange(is_of_piece[other], 1) == 0) front.push_back(other);
  }
  return is_of_piece;
}

}  // namespace burnish
