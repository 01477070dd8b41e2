#include "server/solver/hierarchy/changed_parts.h"

#include <algorithm>

#include "server/solver/hierarchy/index_set.h"

namespace burnish {

namespace {

size_t part_count(const HierarchyDepth& depth) {
  return depth.grid.cells.size() + depth.ties.size() + depth.sheet_count;
}

int32_t part_of_number(const HierarchyDepth& depth, int32_t number) {
  const int32_t of_cells = kNumbersPerCell * depth.grid.cell_count();
  if (number < of_cells) return number / kNumbersPerCell;
  return depth.grid.cell_count() + (number - of_cells) / kNumbersPerTie;
}

// Calls visit(part) for the parts that a corner's row sums.
template <typename Visit>
void visit_parts_of_row(const HierarchyDepth& depth, int32_t corner, Visit&& visit) {
  if (!depth.stencil.is_irregular(corner)) {
    for (const int32_t cell : depth.grid.cells_of_corner[corner])
      if (cell != kNone) visit(cell);
    return;
  }
  const IrregularRows& rows = depth.stencil.irregular;
  const auto i = std::ranges::lower_bound(rows.corner, corner) - rows.corner.begin();
  const int64_t end = rows.source_start[rows.sum_start[i + 1]];
  for (int64_t k = rows.source_start[rows.sum_start[i]]; k < end; ++k)
    visit(part_of_number(depth, rows.source[k]));
}

// Calls visit(corner) for the corners whose rows sum the part. No row sums a sheet.
template <typename Visit>
void visit_corners_of_part(const HierarchyDepth& depth, int32_t part, Visit&& visit) {
  const auto visit_cell = [&](int32_t cell) {
    for (const int32_t corner : depth.grid.cell_corners[cell]) visit(corner);
  };
  const int32_t tie = part - depth.grid.cell_count();
  if (tie < 0) return visit_cell(part);
  if (depth.is_finest()) return;
  visit_cell(depth.ties[tie].first);
  visit_cell(depth.ties[tie].second);
}

// Calls visit(part of the finer depth) for the sources of a coarse part's numbers.
template <typename Visit>
void visit_sources(const HierarchyDepth& coarse, int32_t part, Visit&& visit) {
  if (part < coarse.grid.cell_count())
    for (const int32_t child : coarse.children[part]) visit(child);
  const CellShares& shares = coarse.shares;
  const auto i = std::ranges::lower_bound(shares.target, part) - shares.target.begin();
  if (i == std::ssize(shares.target) || shares.target[i] != part) return;
  for (int32_t k = shares.start[i]; k < shares.start[i + 1]; ++k) visit(shares.share[k].source);
}

std::vector<int32_t> with_sheets(const PreparedMesh& prepared, const HierarchyDepth& finest,
                                 std::span<const int32_t> cells) {
  IndexSet parts(part_count(finest));
  for (const int32_t cell : cells) parts.insert(cell);
  for (int32_t s = 0; s < finest.sheet_count; ++s)
    if (parts.contains(prepared.sheets[s].cell)) parts.insert(finest.grid.cell_count() + s);
  return parts.take_rising();
}

std::vector<int32_t> parts_above(const HierarchyDepth& fine, const HierarchyDepth& coarse,
                                 std::span<const int32_t> fine_parts) {
  IndexSet of_fine(part_count(fine)), parts(part_count(coarse));
  for (const int32_t part : fine_parts) {
    of_fine.insert(part);
    if (part < fine.grid.cell_count() && fine.parent_cell[part] != kNone)
      parts.insert(fine.parent_cell[part]);
  }
  const CellShares& shares = coarse.shares;
  for (size_t i = 0; i < shares.target.size(); ++i)
    for (int32_t k = shares.start[i]; k < shares.start[i + 1]; ++k)
      if (of_fine.contains(shares.share[k].source)) parts.insert(shares.target[i]);
  return parts.take_rising();
}

std::vector<int32_t> rows_of(const HierarchyDepth& depth, std::span<const int32_t> parts) {
  IndexSet rows(depth.grid.corners.size());
  for (const int32_t part : parts)
    visit_corners_of_part(depth, part, [&](int32_t corner) { rows.insert(corner); });
  return rows.take_rising();
}

// `above`: the depth above, and what is needed there; none at the coarsest depth.
std::vector<int32_t> needed_parts(const HierarchyDepth& depth, const ChangedDepth& changed,
                                  const HierarchyDepth* above,
                                  std::span<const int32_t> needed_above) {
  IndexSet needed(part_count(depth));
  const auto insert = [&](int32_t part) { needed.insert(part); };
  for (const int32_t part : changed.parts) insert(part);
  for (const int32_t corner : changed.rows) visit_parts_of_row(depth, corner, insert);
  for (const int32_t part : needed_above) visit_sources(*above, part, insert);
  return needed.take_rising();
}

}  // namespace

std::vector<ChangedDepth> find_changed_parts(const PreparedMesh& prepared,
                                             const Hierarchy& hierarchy,
                                             std::span<const int32_t> cells,
                                             size_t depths_not_kept) {
  const std::vector<HierarchyDepth>& depths = hierarchy.depths;
  std::vector<ChangedDepth> changed(depths.size());
  for (size_t d = depths.size(); d-- > 0;) {
    changed[d].parts = d + 1 == depths.size()
                           ? with_sheets(prepared, depths[d], cells)
                           : parts_above(depths[d + 1], depths[d], changed[d + 1].parts);
    changed[d].rows = rows_of(depths[d], changed[d].parts);
  }
  for (size_t d = 0; d < depths.size(); ++d) {
    const bool keeps = depths.size() - d > depths_not_kept;
    if (keeps)
      changed[d].needed = changed[d].parts;
    else if (d == 0)
      changed[d].needed = needed_parts(depths[d], changed[d], nullptr, {});
    else
      changed[d].needed =
          needed_parts(depths[d], changed[d], &depths[d - 1], changed[d - 1].needed);
  }
  return changed;
}

CellsAround find_cells_around(const HierarchyDepth& depth, std::span<const int32_t> corners) {
  IndexSet cells(depth.grid.cells.size()), all(depth.grid.corners.size());
  for (const int32_t corner : corners) {
    all.insert(corner);
    visit_parts_of_row(depth, corner, [&](int32_t part) {
      if (part < depth.grid.cell_count()) cells.insert(part);
    });
  }
  CellsAround around;
  around.cells = cells.take_rising();
  for (const int32_t cell : around.cells)
    for (const int32_t corner : depth.grid.cell_corners[cell]) all.insert(corner);
  around.corners = all.take_rising();
  return around;
}

}  // namespace burnish
