#include "server/solver/hierarchy/stencil.h"

#include <algorithm>

#include "common/base/resize_touched.h"
#include "common/base/select_numbers.h"
#include "common/grid/stencil_slots.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish {

namespace {

struct Neighbours {
  std::array<int32_t, kSlots> by_slot;  // kNone if the corners share no active cell
  bool is_regular = true;               // no slot has two corners
};

Neighbours neighbours(const SparseGrid& grid, int32_t corner) {
  Neighbours found;
  found.by_slot.fill(kNone);
  for (int a = 0; a < kCornersPerCell; ++a) {
    const int32_t cell = grid.cells_of_corner[corner][a];
    if (cell == kNone) continue;
    for (int b = 0; b < kCornersPerCell; ++b) {
      int32_t& at = found.by_slot[slot_between(a, b)];
      const int32_t neighbour = grid.cell_corners[cell][b];
      found.is_regular &= at == kNone || at == neighbour;
      at = neighbour;
    }
  }
  found.is_regular &= found.by_slot[kSelfSlot] != kNone;
  found.by_slot[kSelfSlot] = kNone;
  return found;
}

std::vector<uint32_t> masks_of(const SparseGrid& grid, std::span<const CellTie> ties) {
  std::vector<uint32_t> masks;
  resize_touched(masks, grid.corners.size());
#pragma omp parallel for schedule(static)
  for (int32_t corner = 0; corner < grid.corner_count(); ++corner) {
    const Neighbours found = neighbours(grid, corner);
    if (!found.is_regular) continue;
    for (int s = 0; s < kSlots; ++s)
      masks[corner] |= static_cast<uint32_t>(found.by_slot[s] != kNone) << s;
  }
  for (const CellTie& tie : ties)
    for (int v = 0; v < kCornersPerCell; ++v) {
      if (tie.first_corners >> v & 1) masks[grid.cell_corners[tie.first][v]] = 0;
      if (tie.second_corners >> v & 1) masks[grid.cell_corners[tie.second][v]] = 0;
    }
  return masks;
}

// Orders the corners of a window by rising length; equal lengths keep their order.
void order_window(const std::vector<int32_t>& length, int32_t first, int32_t last,
                  int32_t* corner_of_row) {
  int32_t next[kSlots + 2] = {};
  const auto digit = [&](int32_t corner) { return std::min(length[corner], kSlots); };
  for (int32_t corner = first; corner < last; ++corner) ++next[digit(corner) + 1];
  const int32_t long_rows = next[kSlots + 1];
  for (int l = 1; l <= kSlots + 1; ++l) next[l] += next[l - 1];
  for (int32_t corner = first; corner < last; ++corner)
    corner_of_row[first + next[digit(corner)]++] = corner;
  std::stable_sort(corner_of_row + last - long_rows, corner_of_row + last,
                   [&](int32_t a, int32_t b) { return length[a] < length[b]; });
}

// Orders the stored rows of the corners: within each window by rising length, else as they are.
void order_rows(const std::vector<int32_t>& length, Stencil& stencil) {
  const auto n = static_cast<int32_t>(length.size());
  resize_touched(stencil.corner_of_row, n);
  resize_touched(stencil.row_of_corner, n);
#pragma omp parallel for schedule(static)
  for (int32_t first = 0; first < n; first += Stencil::kRowWindow) {
    const int32_t last = std::min(first + Stencil::kRowWindow, n);
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

std::vector<int32_t> lengths_of(const Stencil& stencil, const IrregularColumns& irregular) {
  std::vector<int32_t> length(stencil.mask.size());
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < length.size(); ++corner)
    length[corner] = __builtin_popcount(stencil.mask[corner]);
  for (int32_t i = 0; i < stencil.irregular.count(); ++i)
    length[stencil.irregular.corner[i]] = irregular.length(i);
  return length;
}

void fill_columns(const SparseGrid& grid, const IrregularColumns& irregular, Stencil& stencil) {
  const int32_t n = grid.corner_count();
  resize_touched(stencil.column, stencil.row_start[n]);
#pragma omp parallel for schedule(static)
  for (int32_t row = 0; row < n; ++row) {
    const int32_t corner = stencil.corner_of_row[row];
    int32_t* next = &stencil.column[stencil.row_start[row]];
    int32_t* const end = stencil.column.data() + stencil.row_start[row + 1];
    if (!stencil.is_irregular(corner))
      for (int32_t neighbour : neighbours(grid, corner).by_slot) {
        if (neighbour != kNone) *next++ = neighbour;
      }
    else
      next = irregular.copy_row(stencil.irregular, corner, next);
    std::fill(next, end, corner);
  }
}

int32_t entry_of(const Stencil& stencil, int32_t corner, int32_t column) {
  const auto [begin, end] = stencil.row(corner);
  const auto at = std::find(stencil.column.begin() + begin, stencil.column.begin() + end, column);
  return static_cast<int32_t>(at - stencil.column.begin() - begin);
}

std::array<uint16_t, kPairsPerCell> entries_of_pairs(
    const Stencil& stencil, const std::array<int32_t, kCornersPerCell>& corners) {
  std::array<uint16_t, kPairsPerCell> entries;
  for (int a = 0; a < kCornersPerCell; ++a)
    for (int b = a + 1; b < kCornersPerCell; ++b)
      entries[pair_index(a, b)] = static_cast<uint16_t>(entry_of(stencil, corners[a], corners[b]));
  return entries;
}

/// Returns the cells that have an irregular corner.
IrregularCells find_irregular_cells(const SparseGrid& grid, const Stencil& stencil) {
  IrregularCells found;
  if (stencil.irregular.corner.empty()) return found;
  found.cell = select_numbers(grid.cell_count(), [&](int32_t cell) {
    return std::ranges::any_of(grid.cell_corners[cell],
                               [&](int32_t corner) { return stencil.is_irregular(corner); });
  });
  found.entry.resize(found.cell.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < found.cell.size(); ++i)
    found.entry[i] = entries_of_pairs(stencil, grid.cell_corners[found.cell[i]]);
  return found;
}

}  // namespace

Stencil make_stencil(const SparseGrid& grid, std::span<const CellTie> ties) {
  Stencil stencil;
  stencil.mask = masks_of(grid, ties);
  IrregularColumns columns;
  stencil.irregular = find_irregular_rows(grid, ties, stencil.mask, columns);
  order_rows(lengths_of(stencil, columns), stencil);
  fill_columns(grid, columns, stencil);
  stencil.tiles = make_row_tiles(stencil);
  stencil.irregular_cells = find_irregular_cells(grid, stencil);
  return stencil;
}

}  // namespace burnish
