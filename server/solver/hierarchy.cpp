#include "server/solver/hierarchy.h"

#include <algorithm>

#include "common/base/check.h"

namespace burnish {

namespace {

/// The neighbours of one corner by slot, kNone where they share no active cell.
std::array<int32_t, kSlots> neighbours(const SparseGrid& grid, int32_t corner) {
  std::array<int32_t, kSlots> by_slot;
  by_slot.fill(kNone);
  for (int a = 0; a < kCornersPerCell; ++a) {
    const int32_t cell = grid.cells_of_corner[corner][a];
    if (cell == kNone) continue;
    for (int b = 0; b < kCornersPerCell; ++b)
      by_slot[slot_between(a, b)] = grid.cell_corners[cell][b];
  }
  by_slot[kSelfSlot] = kNone;
  return by_slot;
}

// The corners of a window by rising length, else in order.
void order_window(const std::vector<uint8_t>& length, int32_t first, int32_t last,
                  int32_t* corner_of_row) {
  int32_t next[kSlots + 1] = {};
  for (int32_t corner = first; corner < last; ++corner) ++next[length[corner] + 1];
  for (int l = 1; l <= kSlots; ++l) next[l] += next[l - 1];
  for (int32_t corner = first; corner < last; ++corner)
    corner_of_row[first + next[length[corner]]++] = corner;
}

// Stored rows of the corners: in each window by rising length, else in order.
void order_rows(Stencil& stencil) {
  const int32_t n = static_cast<int32_t>(stencil.mask.size());
  std::vector<uint8_t> length(n);
  stencil.corner_of_row.resize(n);
  stencil.row_of_corner.resize(n);
#pragma omp parallel for schedule(static)
  for (int32_t first = 0; first < n; first += Stencil::kRowWindow) {
    const int32_t last = std::min(first + Stencil::kRowWindow, n);
    for (int32_t corner = first; corner < last; ++corner)
      length[corner] = static_cast<uint8_t>(__builtin_popcount(stencil.mask[corner]));
    order_window(length, first, last, stencil.corner_of_row.data());
    for (int32_t row = first; row < last; ++row)
      stencil.row_of_corner[stencil.corner_of_row[row]] = row;
  }
  stencil.row_start.assign(n + 1, 0);
  for (int32_t row = 0; row < n; ++row) {
    constexpr int kPadding = Stencil::kRowPadding;
    const int padded = (length[stencil.corner_of_row[row]] + kPadding - 1) / kPadding * kPadding;
    stencil.row_start[row + 1] = stencil.row_start[row] + padded;
  }
}

Stencil make_stencil(const SparseGrid& grid) {
  const int32_t n = grid.corner_count();
  Stencil stencil;
  stencil.mask.resize(n);
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < n; ++corner) {
    const auto by_slot = neighbours(grid, corner);
    uint32_t mask = 0;
    for (int s = 0; s < kSlots; ++s) mask |= static_cast<uint32_t>(by_slot[s] != kNone) << s;
    stencil.mask[corner] = mask;
  }
  order_rows(stencil);
  stencil.column.resize(stencil.row_start[n]);
#pragma omp parallel for schedule(static)
  for (int32_t row = 0; row < n; ++row) {
    const int32_t corner = stencil.corner_of_row[row];
    int64_t next = stencil.row_start[row];
    for (int32_t neighbour : neighbours(grid, corner))
      if (neighbour != kNone) stencil.column[next++] = neighbour;
    while (next < stencil.row_start[row + 1]) stencil.column[next++] = corner;
  }
  return stencil;
}

std::vector<int32_t> find_parents(const SparseGrid& fine, const SparseGrid& coarse) {
  std::vector<int32_t> parents(fine.cells.size());
#pragma omp parallel for schedule(static)
  for (int32_t c = 0; c < fine.cell_count(); ++c)
    parents[c] = find_key(coarse.cells, parent_key(fine.cells[c]));
  return parents;
}

// The children of every coarse cell, by a counting sort.
void list_children(const std::vector<int32_t>& parent_cell, HierarchyDepth& coarse) {
  coarse.child_start.assign(coarse.grid.cells.size() + 1, 0);
  for (int32_t parent : parent_cell) ++coarse.child_start[parent + 1];
  for (size_t p = 0; p < coarse.grid.cells.size(); ++p)
    coarse.child_start[p + 1] += coarse.child_start[p];
  coarse.child.resize(parent_cell.size());
  std::vector<int32_t> next(coarse.child_start.begin(), coarse.child_start.end() - 1);
  for (size_t c = 0; c < parent_cell.size(); ++c)
    coarse.child[next[parent_cell[c]]++] = static_cast<int32_t>(c);
}

DepthTransfer::FromCell place_in_parent(const HierarchyDepth& fine, int32_t corner) {
  for (int a = 0; a < kCornersPerCell; ++a) {
    const int32_t cell = fine.grid.cells_of_corner[corner][a];
    if (cell == kNone) continue;
    const Vec3i at =
        corner_offset(static_cast<int>(fine.grid.cells[cell].place & 7)) + corner_offset(a);
    return {fine.parent_cell[cell], static_cast<uint8_t>(at.x() + 3 * at.y() + 9 * at.z())};
  }
  BURNISH_CHECK(false, "every corner belongs to a cell");
}

/// The corners of a cell that weigh on one of its half-way points.
struct Weights {
  int count = 0;
  std::array<int8_t, kCornersPerCell> corner;
  std::array<float, kCornersPerCell> weight;
};

std::array<Weights, kSlots> positive_weights() {
  std::array<Weights, kSlots> of_place;
  for (int place = 0; place < kSlots; ++place)
    for (int a = 0; a < kCornersPerCell; ++a) {
      Weights& weights = of_place[place];
      weights.corner[weights.count] = static_cast<int8_t>(a);
      weights.weight[weights.count] = half_way_weights()[place][a];
      if (half_way_weights()[place][a] > 0) ++weights.count;
    }
  return of_place;
}

// Pᵀ by rows: a counting sort of the entries of P by their coarse corner.
void transpose(const SparseGrid& coarse, DepthTransfer& transfer) {
  const auto weights_of_place = positive_weights();
  const auto for_each_entry = [&](auto&& visit) {
    for (size_t fine = 0; fine < transfer.prolongation.size(); ++fine) {
      const DepthTransfer::FromCell from = transfer.prolongation[fine];
      const Weights& weights = weights_of_place[from.place];
      for (int i = 0; i < weights.count; ++i)
        visit(static_cast<int32_t>(fine), coarse.cell_corners[from.cell][weights.corner[i]],
              weights.weight[i]);
    }
  };
  transfer.restriction_start.assign(coarse.corner_count() + 1, 0);
  for_each_entry([&](int32_t, int32_t to, float) { ++transfer.restriction_start[to + 1]; });
  for (int32_t i = 0; i < coarse.corner_count(); ++i)
    transfer.restriction_start[i + 1] += transfer.restriction_start[i];
  transfer.restriction_corner.resize(transfer.restriction_start.back());
  transfer.restriction_weight.resize(transfer.restriction_start.back());
  std::vector<int64_t> next(transfer.restriction_start.begin(),
                            transfer.restriction_start.end() - 1);
  for_each_entry([&](int32_t fine, int32_t to, float weight) {
    transfer.restriction_corner[next[to]] = fine;
    transfer.restriction_weight[next[to]++] = weight;
  });
}

void connect(HierarchyDepth& fine, HierarchyDepth& coarse) {
  fine.parent_cell = find_parents(fine.grid, coarse.grid);
  list_children(fine.parent_cell, coarse);
  fine.to_parent.prolongation.resize(fine.grid.corners.size());
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < fine.grid.corner_count(); ++corner)
    fine.to_parent.prolongation[corner] = place_in_parent(fine, corner);
  transpose(coarse.grid, fine.to_parent);
}

template <typename T>
uint64_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

const std::array<std::array<float, kCornersPerCell>, kSlots>& half_way_weights() {
  static const auto table = [] {
    std::array<std::array<float, kCornersPerCell>, kSlots> weights;
    for (int place = 0; place < kSlots; ++place)
      weights[place] = trilinear_weights(
          {place % 3 * 0.5f, place / 3 % 3 * 0.5f, static_cast<float>(place / 9) * 0.5f});
    return weights;
  }();
  return table;
}

std::shared_ptr<const Hierarchy> make_hierarchy(const PreparedMesh& prepared) {
  std::vector<HierarchyDepth> from_finest(1);
  from_finest[0].grid = make_finest_grid(prepared.frame.depth, prepared.cells);
  const auto is_coarsest = [](const SparseGrid& grid) {
    return grid.corner_count() <= kCoarsestCornersMax || grid.depth <= kCoarsestDepthMin;
  };
  while (!is_coarsest(from_finest.back().grid)) {
    SparseGrid parents = make_parent_grid(from_finest.back().grid);
    from_finest.emplace_back().grid = std::move(parents);
  }
  for (HierarchyDepth& depth : from_finest) depth.stencil = make_stencil(depth.grid);
  for (size_t i = 0; i + 1 < from_finest.size(); ++i) connect(from_finest[i], from_finest[i + 1]);

  auto hierarchy = std::make_shared<Hierarchy>();
  hierarchy->coarsest = from_finest.back().grid.depth;
  hierarchy->finest = prepared.frame.depth;
  hierarchy->depths.assign(std::make_move_iterator(from_finest.rbegin()),
                           std::make_move_iterator(from_finest.rend()));
  return hierarchy;
}

uint64_t Hierarchy::byte_count() const {
  uint64_t bytes = 0;
  for (const HierarchyDepth& depth : depths) {
    bytes += bytes_of(depth.grid.cells) + bytes_of(depth.grid.corners) +
             bytes_of(depth.grid.cell_corners) + bytes_of(depth.grid.cells_of_corner) +
             bytes_of(depth.stencil.corner_of_row) + bytes_of(depth.stencil.row_of_corner) +
             bytes_of(depth.stencil.row_start) + bytes_of(depth.stencil.column) +
             bytes_of(depth.stencil.mask) + bytes_of(depth.parent_cell) +
             bytes_of(depth.child_start) + bytes_of(depth.child) +
             bytes_of(depth.to_parent.prolongation) + bytes_of(depth.to_parent.restriction_start) +
             bytes_of(depth.to_parent.restriction_corner) +
             bytes_of(depth.to_parent.restriction_weight);
  }
  return bytes;
}

}  // namespace burnish
