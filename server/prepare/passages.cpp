#include "server/prepare/passages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "common/base/scratch_array.h"
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

static unsigned axes_of_planes(const Vec3d& a, const Vec3d& b) {
  unsigned axes = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] == b[axis] && a[axis] == std::floor(a[axis])) axes |= 1u << axis;
  return axes;
}

static unsigned axes_of_planes(const std::array<Vec3d, 3>& triangle) {
  return axes_of_planes(triangle[0], triangle[1]) & axes_of_planes(triangle[1], triangle[2]);
}

std::vector<EdgeInPlane> edges_in_planes(const std::array<Vec3d, 3>& triangle) {
  const unsigned of_triangle = axes_of_planes(triangle);
  std::vector<EdgeInPlane> edges;
  for (int e = 0; e < 3; ++e) {
    const Vec3d &a = triangle[e], &b = triangle[(e + 1) % 3];
    const unsigned axes = axes_of_planes(a, b);
    if (axes == of_triangle) continue;
    edges.push_back({axes, {}});
    add_columns_along(a, b, edges.back().columns);
  }
  return edges;
}

// The neighbours in the same slab along all axes except these, by the axes' bits.
static constexpr std::array<Passages, 8> kAlongAxes = [] {
  std::array<Passages, 8> along = {};
  for (unsigned axes = 0; axes < 8; ++axes)
    for (int slot = 0; slot < kSlots; ++slot) {
      const bool moves[3] = {slot % 3 != 1, slot / 3 % 3 != 1, slot / 9 != 1};
      const unsigned across = moves[0] | moves[1] << 1 | moves[2] << 2;
      if (slot != kSelfSlot && (across & ~axes) == 0) along[axes] |= Passages{1} << slot;
    }
  return along;
}();

// A triangle in a grid plane is in the cells above the plane. Its whole area touches the cells
// below.
static Passages below_plane_of(const std::array<Vec3d, 3>& triangle) {
  const unsigned axes = axes_of_planes(triangle);
  constexpr Passages kBelow = Passages{1} << slot_of_offset(-1, 0, 0) |
                              Passages{1} << slot_of_offset(0, -1, 0) |
                              Passages{1} << slot_of_offset(0, 0, -1);
  return (kBelow & kAlongAxes[axes]) | axes << kSlots;
}

TrianglePassages::TrianglePassages(const std::array<Vec3d, 3>& triangle,
                                   std::span<const CellColumn> columns)
    : met_(columns), below_plane_(below_plane_of(triangle)), edges_(edges_in_planes(triangle)) {
  for (const EdgeInPlane& edge : edges_) touched_.emplace_back(edge.columns);
}

void TrianglePassages::move_to(const CellColumn& column) {
  met_.move_to(column);
  for (ColumnsAround& touched : touched_) touched.move_to(column);
}

// Cells straight across the edge are enough: the cells beside have their own passages.
Passages TrianglePassages::at(int k) const {
  const Passages met = met_.passages(k);
  Passages all = met | below_plane_;
  for (size_t e = 0; e < edges_.size(); ++e) {
    const unsigned axes = edges_[e].axes;
    const Passages touched = touched_[e].passages(k) & kAlongAxes[axes] & ~met;
    if (touched != 0) all |= touched | axes << kSlots;
  }
  return all;
}

// Calls visit(slot, index) for each of these passages; the index is kNone if there is no cell.
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

static Passages doubtful(Passages passages) {
  const unsigned axes_without_doubt = ~passages >> kSlots & 7;
  return passages & kAllPassages & ~kAlongAxes[axes_without_doubt];
}

void close_one_sided_passages(std::span<const MortonKey> cells, std::span<Passages> passages,
                              const ScratchSpace& space) {
  const ScratchArray<Passages> claimed = copy_to(space, passages);
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < cells.size(); ++c) {
    if ((claimed[c] & kInDoubt) == 0) continue;
    passages[c] &= kAllPassages;
    for_each_neighbour(cells[c], doubtful(claimed[c]), cells, [&](int slot, ptrdiff_t neighbour) {
      const bool returns =
          neighbour != kNone && (claimed[neighbour] >> opposite_slot(slot) & 1) != 0;
      if (!returns) passages[c] &= ~(Passages{1} << slot);
    });
  }
}

}  // namespace burnish
