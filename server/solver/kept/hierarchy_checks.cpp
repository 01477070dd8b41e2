#include "server/solver/kept/hierarchy_checks.h"

#include <algorithm>

#include "server/solver/hierarchy/half_way.h"
#include "server/solver/hierarchy/patches.h"
#include "server/solver/kept/array_checks.h"

namespace burnish {

namespace {

Status check_grid(const SparseGrid& grid) {
  const MortonKey end = MortonKey{1} << 3 * grid.depth;
  const bool has_cells =
      !grid.cells.empty() && grid.cells.size() <= INT32_MAX && are_rising(grid.cells) &&
      all_of_numbers(grid.cells.size(), [&](size_t c) { return grid.cells[c].place < end; });
  RETURN_IF_ERROR(check_arrays(has_cells, grid.depth, "cells"));
  const bool has_corners = grid.corners.size() <= INT32_MAX && are_rising(grid.corners) &&
                           grid.cell_corners.size() == grid.cells.size() &&
                           are_within(grid.cell_corners, 0, grid.corner_count());
  return check_arrays(has_corners, grid.depth, "corners");
}

Status check_ties(const HierarchyDepth& depth) {
  const int64_t cells = depth.grid.cell_count();
  const bool are_right = all_of_numbers(depth.ties.size(), [&](size_t i) {
    const CellTie& tie = depth.ties[i];
    return tie.first >= 0 && tie.first < tie.second && tie.second < cells;
  });
  const bool have_numbers = depth.number_count() <= INT32_MAX;
  return check_arrays(are_right && have_numbers, depth.grid.depth, "ties");
}

Status check_children(const HierarchyDepth& fine, const HierarchyDepth& coarse) {
  const Groups<int32_t>& children = coarse.children;
  const auto has_few = [&](size_t i) {
    return children.start[i + 1] - children.start[i] <= kCornersPerCell;
  };
  const bool are_right =
      fine.parent_cell.size() == fine.grid.cells.size() &&
      are_within(fine.parent_cell, kNone, coarse.grid.cell_count()) &&
      are_starts(children.start, coarse.grid.cells.size(), children.item.size()) &&
      all_of_numbers(coarse.grid.cells.size(), has_few) &&
      are_within(children.item, 0, fine.grid.cell_count());
  return check_arrays(are_right, coarse.grid.depth, "parents and children");
}

bool are_shares(const CellShares& shares, int64_t sources) {
  const auto parts = static_cast<int64_t>(shares.part.size());
  const bool have_octants = shares.share.empty() || parts >= kCornersPerCell;
  return have_octants && all_of_numbers(shares.share.size(), [&](size_t i) {
           const CellShare& share = shares.share[i];
           return share.source >= 0 && share.source < sources && share.left >= 0 &&
                  share.left < parts && share.right >= 0 && share.right < parts;
         });
}

Status check_shares(const HierarchyDepth& fine, const HierarchyDepth& coarse) {
  const CellShares& shares = coarse.shares;
  const auto targets = static_cast<int64_t>(coarse.grid.cells.size() + coarse.ties.size());
  const auto sources =
      static_cast<int64_t>(fine.grid.cells.size() + fine.ties.size()) + fine.sheet_count;
  const auto has_places = [&](size_t i) {
    return std::ranges::all_of(shares.part[i].place, [](uint8_t p) { return p < kHalfWayPoints; });
  };
  const bool starts = shares.target.empty()
                          ? shares.share.empty()
                          : are_starts(shares.start, shares.target.size(), shares.share.size());
  const bool are_right =
      starts && are_rising(shares.target) && are_within(shares.target, 0, targets) &&
      all_of_numbers(shares.part.size(), has_places) && are_shares(shares, sources) &&
      are_rising(shares.apart) && are_within(shares.apart, 0, fine.grid.cell_count());
  return check_arrays(are_right, coarse.grid.depth, "shares");
}

bool is_prolongation(const DepthTransfer& transfer, int64_t fine_corners, int64_t coarse_cells) {
  if (static_cast<int64_t>(transfer.prolongation.size()) != fine_corners) return false;
  return all_of_numbers(transfer.prolongation.size(), [&](size_t i) {
    const FromCell from = transfer.prolongation[i];
    return from.cell >= kNone && from.cell < coarse_cells && from.place < kHalfWayPoints;
  });
}

// Every corner without a cell is listed as shared, and no other.
bool are_shared_corners(const DepthTransfer& transfer, int64_t coarse_corners) {
  const DepthTransfer::SharedCorners& shared = transfer.shared;
  const auto without_cell = std::ranges::count(transfer.prolongation, kNone, &FromCell::cell);
  const auto fine_corners = static_cast<int64_t>(transfer.prolongation.size());
  return are_rising(shared.corner) && are_within(shared.corner, 0, fine_corners) &&
         without_cell == std::ssize(shared.corner) &&
         all_of_numbers(shared.corner.size(),
                        [&](size_t i) { return transfer.is_shared(shared.corner[i]); }) &&
         are_starts(shared.start, shared.corner.size(), shared.coarse_corner.size()) &&
         are_within(shared.coarse_corner, 0, coarse_corners) &&
         shared.weight.size() == shared.coarse_corner.size();
}

Status check_transfer(const HierarchyDepth& fine, const HierarchyDepth& coarse) {
  const DepthTransfer& transfer = fine.to_parent;
  const bool are_right =
      is_prolongation(transfer, fine.grid.corner_count(), coarse.grid.cell_count()) &&
      are_shared_corners(transfer, coarse.grid.corner_count()) &&
      are_starts(transfer.restriction_start, coarse.grid.corners.size(),
                 transfer.restriction_corner.size()) &&
      are_within(transfer.restriction_corner, 0, fine.grid.corner_count()) &&
      transfer.restriction_weight.size() == transfer.restriction_corner.size();
  return check_arrays(are_right, fine.grid.depth, "prolongation and restriction");
}

// The coarsest depth has no parents, the finest no children.
Status check_ends(const Hierarchy& hierarchy) {
  const HierarchyDepth& coarsest = hierarchy.depths.front();
  const HierarchyDepth& finest = hierarchy.depths.back();
  const bool are_ends = coarsest.parent_cell.empty() && coarsest.to_parent.prolongation.empty() &&
                        coarsest.to_parent.restriction_corner.empty() &&
                        are_starts(finest.children.start, 0, finest.children.item.size()) &&
                        finest.children.item.empty() && finest.ties.empty() &&
                        finest.shares.share.empty();
  return check_arrays(are_ends, hierarchy.finest, "the coarsest and the finest depth");
}

Status check_finest(const Hierarchy& hierarchy, const PreparedMesh& prepared) {
  const HierarchyDepth& finest = hierarchy.depths.back();
  const std::vector<GridKey>& cells = finest.grid.cells;
  const bool are_right =
      cells.size() == prepared.cells.size() &&
      all_of_numbers(cells.size(), [&](size_t c) { return cells[c].place == prepared.cells[c]; }) &&
      (finest.sheet_count == 0 || std::ssize(prepared.sheets) == finest.sheet_count) &&
      are_starts(hierarchy.points.start, cells.size(), hierarchy.points.item.size());
  return check_arrays(are_right, hierarchy.finest, "cells and the prepared mesh");
}

Status check_patches(const Patches& patches, const SparseGrid& finest) {
  const std::vector<int64_t>& entry = patches.entry_start;
  const auto is_patch = [&](size_t i) {
    const int64_t corners = patches.start[i + 1] - patches.start[i];
    return corners >= 1 && corners <= kPatchCornersMax &&
           entry[i + 1] - entry[i] == corners * (corners + 1) / 2;
  };
  const auto count = patches.start.empty() ? 0 : patches.start.size() - 1;
  const bool are_right =
      are_starts(patches.start, count, patches.corner.size()) && entry.size() == count + 1 &&
      entry.front() == 0 && all_of_numbers(count, is_patch) &&
      are_within(patches.corner, 0, finest.corner_count()) && !patches.colour_start.empty() &&
      are_starts(patches.colour_start, patches.colour_start.size() - 1, count);
  return check_arrays(are_right, finest.depth, "patches");
}

Status check_between(const HierarchyDepth& fine, const HierarchyDepth& coarse) {
  RETURN_IF_ERROR(check_children(fine, coarse));
  RETURN_IF_ERROR(check_shares(fine, coarse));
  return check_transfer(fine, coarse);
}

// A corner with cells of several sheets on one side has an irregular row, which lists them.
void find_cells_of_corners(HierarchyDepth& depth) {
  SparseGrid& grid = depth.grid;
  clear_cells_of_corners(grid);
#pragma omp parallel for schedule(static)
  for (int32_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int a = 0; a < kCornersPerCell; ++a) {
      const int32_t corner = grid.cell_corners[cell][a];
      if (!depth.stencil.is_irregular(corner)) grid.cells_of_corner[corner][a] = cell;
    }
}

}  // namespace

Status check_and_complete(Hierarchy& hierarchy, const CyclePlan& plan,
                          const PreparedMesh& prepared) {
  for (HierarchyDepth& depth : hierarchy.depths) {
    RETURN_IF_ERROR(check_grid(depth.grid));
    RETURN_IF_ERROR(check_ties(depth));
    RETURN_IF_ERROR(check_and_complete_stencil(depth));
    find_cells_of_corners(depth);
  }
  for (size_t i = 1; i < hierarchy.depths.size(); ++i)
    RETURN_IF_ERROR(check_between(hierarchy.depths[i], hierarchy.depths[i - 1]));
  RETURN_IF_ERROR(check_ends(hierarchy));
  RETURN_IF_ERROR(check_finest(hierarchy, prepared));
  RETURN_IF_ERROR(check_patches(hierarchy.small_components, hierarchy.depths.back().grid));
  return check_patches(plan.patches, hierarchy.depths.back().grid);
}

}  // namespace burnish
