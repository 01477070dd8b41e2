#include <algorithm>
#include <bit>

#include "common/base/resize_touched.h"
#include "common/grid/stencil_slots.h"
#include "server/solver/hierarchy/cell_matrix.h"
#include "server/solver/kept/array_checks.h"
#include "server/solver/kept/hierarchy_checks.h"

namespace burnish {

namespace {

// Returns the slots in which local corner a sees the others of its cell.
uint32_t slots_in_cell(int a) {
  uint32_t slots = 0;
  for (int b = 0; b < kCornersPerCell; ++b)
    if (b != a) slots |= 1u << slot_between(a, b);
  return slots;
}

// A row has a place for every corner with which its own shares a cell.
bool are_masks(const SparseGrid& grid, const std::vector<uint32_t>& mask) {
  std::array<uint32_t, kCornersPerCell> slots;
  for (int a = 0; a < kCornersPerCell; ++a) slots[a] = slots_in_cell(a);
  constexpr uint32_t kOthers = ((1u << kSlots) - 1) & ~(1u << kSelfSlot);
  return mask.size() == grid.corners.size() &&
         all_of_numbers(mask.size(), [&](size_t i) { return (mask[i] & ~kOthers) == 0; }) &&
         all_of_numbers(grid.cells.size(), [&](size_t cell) {
           for (int a = 0; a < kCornersPerCell; ++a) {
             const uint32_t has = mask[grid.cell_corners[cell][a]];
             if (has != 0 && (has & slots[a]) != slots[a]) return false;
           }
           return true;
         });
}

// Each corner has one row, in the tile in which it would be without an order.
bool number_rows(Stencil& stencil) {
  const size_t n = stencil.mask.size();
  if (stencil.corner_of_row.size() != n ||
      !are_within(stencil.corner_of_row, 0, static_cast<int64_t>(n)))
    return false;
  resize_touched(stencil.row_of_corner, n);
  std::ranges::fill(stencil.row_of_corner, kNone);
  for (size_t row = 0; row < n; ++row)
    stencil.row_of_corner[stencil.corner_of_row[row]] = static_cast<int32_t>(row);
  return all_of_numbers(n, [&](size_t corner) {
    const int32_t row = stencil.row_of_corner[corner];
    return row != kNone && row / RowTiles::kRows == static_cast<int32_t>(corner) / RowTiles::kRows;
  });
}

bool are_rows(const Stencil& stencil) {
  constexpr int64_t kGroup = Stencil::kRowPadding;
  const size_t n = stencil.mask.size();
  if (!are_starts(stencil.row_start, n, stencil.column.size())) return false;
  return are_within(stencil.column, 0, static_cast<int64_t>(n)) &&
         all_of_numbers(n, [&](size_t row) {
           const int64_t length = stencil.row_start[row + 1] - stencil.row_start[row];
           const int64_t entries = std::popcount(stencil.mask[stencil.corner_of_row[row]]);
           const bool is_right = entries == 0 || length == (entries + kGroup - 1) / kGroup * kGroup;
           return is_right && length % kGroup == 0 && length / kGroup <= UINT16_MAX;
         });
}

Status check_rows(const SparseGrid& grid, Stencil& stencil) {
  const bool are_right = are_masks(grid, stencil.mask) && number_rows(stencil) && are_rows(stencil);
  return check_arrays(are_right, grid.depth, "masks, rows and columns");
}

void make_rows_of_tiles(Stencil& stencil) {
  std::vector<RowTiles::Row>& rows = stencil.tiles.row;
  resize_touched(rows, stencil.mask.size());
#pragma omp parallel for schedule(static)
  for (size_t row = 0; row < rows.size(); ++row) {
    const int64_t length = stencil.row_start[row + 1] - stencil.row_start[row];
    rows[row] = {static_cast<uint16_t>(stencil.corner_of_row[row] % RowTiles::kRows),
                 static_cast<uint16_t>(length / Stencil::kRowPadding)};
  }
}

// Returns the corners of a tile and of its halo; 0 for a tile that is wide.
int32_t width_of(const Stencil& stencil, int32_t tile) {
  const RowTiles& tiles = stencil.tiles;
  if (tiles.is_wide[tile] != 0) return 0;
  const int32_t begin = tile * RowTiles::kRows;
  const auto n = static_cast<int32_t>(stencil.mask.size());
  const auto rows = std::min(RowTiles::kRows, n - begin);
  const auto halo = std::min<size_t>(tiles.halo[tile].size(), INT32_MAX / 2);
  return rows + static_cast<int32_t>(halo);
}

bool is_tile(const Stencil& stencil, int32_t tile) {
  const int32_t width = width_of(stencil, tile);
  if (width > RowTiles::kWidthMax) return false;
  if (width == 0) return stencil.tiles.halo[tile].empty();
  const auto n = static_cast<int32_t>(stencil.mask.size());
  const int32_t begin = tile * RowTiles::kRows, end = std::min(begin + RowTiles::kRows, n);
  for (int64_t k = stencil.row_start[begin]; k < stencil.row_start[end]; ++k) {
    const int place = stencil.tiles.twice_local[k];
    if (place % 2 != 0 || place / 2 >= width) return false;
  }
  return true;
}

Status check_tiles(int depth, Stencil& stencil) {
  RowTiles& tiles = stencil.tiles;
  const size_t n = stencil.mask.size();
  const size_t count = (n + RowTiles::kRows - 1) / RowTiles::kRows;
  const bool are_right =
      tiles.is_wide.size() == count && tiles.twice_local.size() == stencil.column.size() &&
      are_starts(tiles.halo.start, count, tiles.halo.item.size()) &&
      are_within(tiles.halo.item, 0, static_cast<int64_t>(n)) &&
      all_of_numbers(count, [&](size_t i) { return is_tile(stencil, static_cast<int32_t>(i)); });
  RETURN_IF_ERROR(check_arrays(are_right, depth, "tiles and halos"));
  make_rows_of_tiles(stencil);
  for (int32_t tile = 0; tile < tiles.count(); ++tile)
    tiles.width_max = std::max(tiles.width_max, width_of(stencil, tile));
  return Status::ok();
}

// The corners without a mask are listed, each with a sum for its entries and one for its row sum.
bool are_irregular_rows(const Stencil& stencil, int64_t numbers) {
  const IrregularRows& rows = stencil.irregular;
  const auto n = static_cast<int64_t>(stencil.mask.size());
  if (std::ranges::count(stencil.mask, 0u) != rows.count()) return false;
  if (!are_rising(rows.corner) || !are_within(rows.corner, 0, n) || rows.source_start.empty())
    return false;
  const size_t sums = rows.source_start.size() - 1;
  return are_starts(rows.sum_start, rows.corner.size(), sums) &&
         are_starts(rows.source_start, sums, rows.source.size()) &&
         are_within(rows.source, 0, numbers) && all_of_numbers(rows.corner.size(), [&](size_t i) {
           const auto [begin, end] = stencil.row(rows.corner[i]);
           return stencil.is_irregular(rows.corner[i]) &&
                  rows.sum_start[i + 1] - rows.sum_start[i] == end - begin + 1;
         });
}

bool are_irregular_cells(const HierarchyDepth& depth) {
  const IrregularCells& cells = depth.stencil.irregular_cells;
  const SparseGrid& grid = depth.grid;
  if (cells.entry.size() != cells.cell.size() || !are_rising(cells.cell) ||
      !are_within(cells.cell, 0, grid.cell_count()))
    return false;
  return all_of_numbers(cells.cell.size(), [&](size_t i) {
    for (int a = 0; a < kCornersPerCell; ++a) {
      const auto [begin, end] = depth.stencil.row(grid.cell_corners[cells.cell[i]][a]);
      for (int b = a + 1; b < kCornersPerCell; ++b)
        if (cells.entry[i][pair_index(a, b)] >= end - begin) return false;
    }
    return true;
  });
}

}  // namespace

Status check_and_complete_stencil(HierarchyDepth& depth) {
  RETURN_IF_ERROR(check_rows(depth.grid, depth.stencil));
  RETURN_IF_ERROR(check_tiles(depth.grid.depth, depth.stencil));
  const bool are_right =
      are_irregular_rows(depth.stencil, static_cast<int64_t>(depth.number_count())) &&
      are_irregular_cells(depth);
  return check_arrays(are_right, depth.grid.depth, "irregular rows and cells");
}

}  // namespace burnish
