#include "server/solver/hierarchy/hierarchy.h"

#include <algorithm>

#include "common/base/resize_touched.h"
#include "common/base/select_numbers.h"
#include "server/solver/hierarchy/coarse_grid.h"
#include "server/solver/hierarchy/sheets/sheet_corners.h"
#include "server/solver/hierarchy/sheets/small_components.h"

namespace burnish {

namespace {

// If more than one in this many corners has a second copy, the finest depth keeps sheets together
// and only the depths above it keep them apart. A soup, where nothing hangs together, would have
// eight corners for each cell.
constexpr int32_t kCornersPerExtraCopy = 8;
constexpr int64_t kIrregularRowMax = 4096;  // entries

// Returns the children of every coarse cell, except those that are apart.
Groups<int32_t> children_of(const std::vector<int32_t>& parent_cell, const HierarchyDepth& coarse) {
  std::vector<int32_t> parent_of_child = parent_cell;
  for (int32_t cell : coarse.shares.apart) parent_of_child[cell] = kNone;
  return group_numbers(coarse.grid.cells.size(), static_cast<int32_t>(parent_of_child.size()),
                       [&](int32_t cell) { return parent_of_child[cell]; });
}

HierarchyDepth make_parent_depth(HierarchyDepth& fine, CoarseGrid coarse, TiesAndShares numbers) {
  HierarchyDepth parents;
  fine.parent_cell = std::move(coarse.parent_cell);
  parents.grid = std::move(coarse.grid);
  parents.ties = std::move(numbers.ties);
  parents.shares = std::move(numbers.shares);
  parents.children = children_of(fine.parent_cell, parents);
  return parents;
}

HierarchyDepth make_joined_parents(HierarchyDepth& fine) {
  CoarseGrid coarse = join_sheets(fine.grid);
  fine.to_parent = make_transfer(coarse);
  return make_parent_depth(fine, std::move(coarse), {});
}

// Returns the half-way point of a coarse cell that is nearest to a corner of the depth below.
uint8_t nearest_place(const GridKey& cell, const GridKey& corner) {
  const Vec3i from_cell = morton_point(corner.place) - 2 * morton_point(cell.place);
  const Vec3i at = from_cell.cwiseMax(0).cwiseMin(2);
  return static_cast<uint8_t>(at.x() + 3 * at.y() + 9 * at.z());
}

// Returns the coarse grid of all sheets but those of small components. These have no parent: each
// takes its values from the cell at its anchor.
CoarseGrid keep_sheets_apart(const SparseGrid& finest, const SheetCorners& sheets,
                             std::span<const SmallComponent> components) {
  if (components.empty())
    return keep_sheets_apart(finest.depth - 1, sheets.cell, sheets.corners, sheets.copy_count);
  std::vector<char> is_of_small_component(sheets.copy_count);
  for (const SmallComponent& component : components)
    for (const int32_t copy : component.copies) is_of_small_component[copy] = 1;
  const std::vector<int32_t> kept =
      select_numbers(static_cast<int32_t>(sheets.cell.size()),
                     [&](int32_t s) { return is_of_small_component[sheets.corners[s][0]] == 0; });
  CoarseGrid coarse = keep_sheets_apart(
      finest.depth - 1, gather<GridKey>(sheets.cell, kept),
      gather<std::array<int32_t, kCornersPerCell>>(sheets.corners, kept), sheets.copy_count);
  std::vector<int32_t> parents(sheets.cell.size(), kNone);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < kept.size(); ++i) parents[kept[i]] = coarse.parent_cell[i];
  coarse.parent_cell = std::move(parents);
  const std::vector<int32_t> anchors = find_anchors(components, sheets);
  for (size_t i = 0; i < components.size(); ++i) {
    if (anchors[i] == kNone) continue;
    const int32_t cell = coarse.from[anchors[i]].cell;
    for (size_t k = 0; k < components[i].copies.size(); ++k)
      coarse.from[components[i].copies[k]] = {
          cell, nearest_place(coarse.grid.cells[cell], finest.corners[components[i].corners[k]])};
  }
  return coarse;
}

HierarchyDepth make_parents_of_finest(HierarchyDepth& finest, const SheetCorners& sheets,
                                      std::span<const SmallComponent> components) {
  CoarseGrid coarse = keep_sheets_apart(finest.grid, sheets, components);
  finest.to_parent = make_transfer(coarse, sheets, finest.grid.corner_count());
  TiesAndShares numbers = share_cells(finest.grid, sheets, coarse);
  std::vector<int32_t> parent_of_sheet = std::move(coarse.parent_cell);
  resize_touched(coarse.parent_cell, finest.grid.cells.size());
#pragma omp parallel for schedule(static)
  for (int32_t cell = 0; cell < finest.grid.cell_count(); ++cell)
    coarse.parent_cell[cell] = parent_of_sheet[sheets.first_of_cell[cell]];
  return make_parent_depth(finest, std::move(coarse), std::move(numbers));
}

HierarchyDepth make_parents_apart(HierarchyDepth& fine) {
  CoarseGrid coarse = keep_sheets_apart(fine.grid.depth - 1, fine.grid.cells,
                                        fine.grid.cell_corners, fine.grid.corner_count());
  fine.to_parent = make_transfer(coarse);
  TiesAndShares numbers = share_ties(fine.grid, fine.ties, coarse);
  return make_parent_depth(fine, std::move(coarse), std::move(numbers));
}

bool is_coarsest(const SparseGrid& grid) {
  return grid.corner_count() <= kCoarsestCornersMax || grid.depth <= kCoarsestDepthMin;
}

// Makes all depths without their stencils, the finest first.
std::vector<HierarchyDepth> joined_depths(SparseGrid finest) {
  std::vector<HierarchyDepth> depths(1);
  depths[0].grid = std::move(finest);
  while (!is_coarsest(depths.back().grid)) depths.push_back(make_joined_parents(depths.back()));
  return depths;
}

std::vector<HierarchyDepth> depths_apart(SparseGrid finest, SheetCorners sheets,
                                         std::span<const SmallComponent> components) {
  std::vector<HierarchyDepth> depths(1);
  depths[0].grid = std::move(finest);
  if (is_coarsest(depths[0].grid)) return depths;
  depths.push_back(make_parents_of_finest(depths[0], sheets, components));
  sheets = {};  // it is as large as the finest grid
  while (!is_coarsest(depths.back().grid)) depths.push_back(make_parents_apart(depths.back()));
  return depths;
}

// Lists an irregular corner's cells only with its row.
void add_stencil(HierarchyDepth& depth) {
  depth.stencil = make_stencil(depth.grid, depth.ties);
  for (int32_t corner : depth.stencil.irregular.corner)
    depth.grid.cells_of_corner[corner].fill(kNone);
}

bool has_endless_rows(const HierarchyDepth& depth) {
  return std::ranges::any_of(depth.stencil.irregular.corner, [&](int32_t corner) {
    const auto [begin, end] = depth.stencil.row(corner);
    return end - begin > kIrregularRowMax;
  });
}

// Makes patches on small components. Returns those that need no coarse cells beside them.
std::vector<SmallComponent> components_with_patches(const SparseGrid& finest,
                                                    const SheetCorners& sheets, Patches& patches) {
  std::vector<SmallComponent> found = find_small_components(finest, sheets), components;
  std::vector<std::vector<int32_t>> sets;
  for (const SmallComponent& component : found) sets.push_back(component.patch);
  std::vector<char> was_left_out;
  patches = make_patches(finest, sets, &was_left_out);
  for (size_t i = 0; i < found.size(); ++i)
    if (!was_left_out[i] && !found[i].needs_coarse_cells) components.push_back(std::move(found[i]));
  return components;
}

std::vector<HierarchyDepth> make_depths(const PreparedMesh& prepared, Sheets sheets,
                                        Patches& patches) {
  SparseGrid finest = make_finest_grid(prepared.frame.depth, prepared.cells);
  if (sheets == Sheets::kTogether) return joined_depths(std::move(finest));
  SheetCorners corners = find_sheet_corners(prepared, finest);
  if (corners.copy_count - finest.corner_count() > finest.corner_count() / kCornersPerExtraCopy) {
    corners = one_sheet_per_cell(finest);
    return depths_apart(std::move(finest), std::move(corners), {});
  }
  const std::vector<SmallComponent> components = components_with_patches(finest, corners, patches);
  std::vector<HierarchyDepth> depths =
      depths_apart(std::move(finest), std::move(corners), components);
  depths[0].sheet_count = static_cast<int32_t>(prepared.sheets.size());
  return depths;
}

template <typename... T>
uint64_t bytes_of(const std::vector<T>&... vectors) {
  return (... + (vectors.capacity() * sizeof(T)));
}

uint64_t bytes_of(const SparseGrid& grid) {
  return bytes_of(grid.cells, grid.corners, grid.cell_corners, grid.cells_of_corner);
}

uint64_t bytes_of(const Stencil& stencil) {
  const IrregularRows& rows = stencil.irregular;
  const IrregularCells& cells = stencil.irregular_cells;
  const RowTiles& tiles = stencil.tiles;
  return bytes_of(stencil.corner_of_row, stencil.row_of_corner, stencil.row_start, stencil.column,
                  stencil.mask) +
         bytes_of(tiles.row, tiles.twice_local, tiles.is_wide) + tiles.halo.byte_count() +
         bytes_of(rows.corner, rows.sum_start, rows.source_start, rows.source) +
         bytes_of(cells.cell, cells.entry);
}

uint64_t bytes_of(const DepthTransfer& transfer) {
  const DepthTransfer::SharedCorners& shared = transfer.shared;
  return bytes_of(transfer.prolongation, transfer.restriction_start, transfer.restriction_corner,
                  transfer.restriction_weight) +
         bytes_of(shared.corner, shared.start, shared.coarse_corner, shared.weight);
}

uint64_t bytes_of(const CellShares& shares) {
  return bytes_of(shares.part, shares.target, shares.start, shares.share, shares.apart);
}

}  // namespace

Result<std::shared_ptr<const Hierarchy>> make_hierarchy(const PreparedMesh& prepared,
                                                        const Progress& progress, Sheets sheets) {
  const auto goes_on = [&](double fraction) {
    return report(progress, "connecting cells", fraction);
  };
  static const char kCancelled[] = "cancelled while connecting cells";
  if (!goes_on(0)) return cancelled(kCancelled);
  Patches components;
  std::vector<HierarchyDepth> from_finest = make_depths(prepared, sheets, components);
  for (HierarchyDepth& depth : from_finest) {
    if (!goes_on(0.5)) return cancelled(kCancelled);
    add_stencil(depth);
  }
  if (sheets == Sheets::kApart && std::ranges::any_of(from_finest, has_endless_rows))
    return make_hierarchy(prepared, progress, Sheets::kTogether);

  auto hierarchy = std::make_shared<Hierarchy>();
  hierarchy->coarsest = from_finest.back().grid.depth;
  hierarchy->finest = prepared.frame.depth;
  hierarchy->depths.assign(std::make_move_iterator(from_finest.rbegin()),
                           std::make_move_iterator(from_finest.rend()));
  hierarchy->small_components = std::move(components);
  hierarchy->points = sort_by_cell(prepared.evaluation, hierarchy->depths.back().grid.cell_count());
  return std::shared_ptr<const Hierarchy>(std::move(hierarchy));
}

uint64_t Hierarchy::byte_count() const {
  uint64_t bytes = points.byte_count() + small_components.byte_count();
  for (const HierarchyDepth& depth : depths)
    bytes += bytes_of(depth.grid) + bytes_of(depth.stencil) + bytes_of(depth.to_parent) +
             bytes_of(depth.shares) + depth.children.byte_count() +
             bytes_of(depth.ties, depth.parent_cell);
  return bytes;
}

}  // namespace burnish
