#include "server/prepare/passages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "common/grid/sparse_grid.h"

namespace burnish {

void ColumnsAround::move_to(const CellColumn& column) {
  near_count_ = 0;
  for (int dx = -1; dx <= 1; ++dx) {
    const std::pair first(column.i + dx, column.j - 1), last(column.i + dx, column.j + 1);
    const auto place = [&](size_t c) { return std::pair(columns_[c].i, columns_[c].j); };
    size_t& row = row_[dx + 1];
    while (row < columns_.size() && place(row) < first) ++row;
    for (size_t c = row; c < columns_.size() && place(c) <= last; ++c)
      near_[near_count_++] = {columns_[c].k, slot_of_offset(dx, columns_[c].j - column.j, -1)};
  }
}

Passages ColumnsAround::passages(int k) const {
  constexpr int kStep = slot_of_offset(0, 0, 1) - slot_of_offset(0, 0, 0);
  Passages found = 0;
  for (int n = 0; n < near_count_; ++n) {
    const auto& [range, lowest_slot] = near_[n];
    for (int dz = -1; dz <= 1; ++dz)
      if (k + dz >= range.first && k + dz <= range.last)
        found |= Passages{1} << (lowest_slot + (dz + 1) * kStep);
  }
  return found & kAllPassages;
}

static bool is_in_plane(const Vec3d& a, const Vec3d& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] == b[axis] && a[axis] == std::floor(a[axis])) return true;
  return false;
}

bool has_edge_in_plane(const std::array<Vec3d, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return is_in_plane(a, b) || is_in_plane(b, c) || is_in_plane(c, a);
}

std::vector<CellColumn> with_touched(const std::array<Vec3d, 3>& triangle,
                                     std::span<const CellColumn> columns) {
  std::vector<CellColumn> all(columns.begin(), columns.end());
  for (int e = 0; e < 3; ++e) {
    const Vec3d &a = triangle[e], &b = triangle[(e + 1) % 3];
    if (is_in_plane(a, b)) add_columns_along(a, b, all);
  }
  const auto place = [](const CellColumn& column) { return std::pair(column.i, column.j); };
  std::ranges::sort(all, {}, place);
  size_t kept = 0;
  for (const CellColumn& column : all) {
    if (kept == 0 || place(all[kept - 1]) != place(column)) {
      all[kept++] = column;
      continue;
    }
    SlabRange& range = all[kept - 1].k;
    range = {std::min(range.first, column.k.first), std::max(range.last, column.k.last)};
  }
  all.resize(kept);
  return all;
}

// Calls visit(slot, index) for each of these passages; the index is kNone where there is no cell.
template <typename Visit>
static void for_each_neighbour(MortonKey cell, Passages passages, std::span<const MortonKey> cells,
                               Visit&& visit) {
  for (Passages left = passages & kAllPassages; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    const MortonKey key = morton_key(morton_point(cell) + offset_of_slot(slot));
    const auto at = std::ranges::lower_bound(cells, key);
    visit(slot, at != cells.end() && *at == key ? at - cells.begin() : kNone);
  }
}

void doubt_passages_to(size_t cell, std::span<const MortonKey> cells,
                       std::span<Passages> passages) {
  for_each_neighbour(cells[cell], passages[cell], cells, [&](int, ptrdiff_t neighbour) {
    if (neighbour != kNone) passages[neighbour] |= kInDoubt;
  });
}

// In any order: neither of two passages that return each other is ever closed.
void close_one_sided_passages(std::span<const MortonKey> cells, std::span<Passages> passages) {
  for (size_t c = 0; c < cells.size(); ++c) {
    if ((passages[c] & kInDoubt) == 0) continue;
    passages[c] &= ~kInDoubt;
    for_each_neighbour(cells[c], passages[c], cells, [&](int slot, ptrdiff_t neighbour) {
      const bool returns =
          neighbour != kNone && (passages[neighbour] >> opposite_slot(slot) & 1) != 0;
      if (!returns) passages[c] &= ~(Passages{1} << slot);
    });
  }
}

}  // namespace burnish
