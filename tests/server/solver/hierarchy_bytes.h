#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <vector>

#include "server/solver/cycle/cycle_plan.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish {

/// Gathers the bytes of a hierarchy, without those between fields.
class HierarchyBytes {
 public:
  static std::string of(const Hierarchy& hierarchy) {
    HierarchyBytes bytes;
    for (const HierarchyDepth& depth : hierarchy.depths) bytes.add(depth);
    bytes.add(hierarchy.coarsest, hierarchy.finest, hierarchy.points.start, hierarchy.points.item,
              hierarchy.small_components);
    return std::move(bytes.bytes_);
  }

  static std::string of(const CyclePlan& plan) {
    HierarchyBytes bytes;
    bytes.add(plan.first_weak_depth, plan.has_flat_parts, plan.patches);
    return std::move(bytes.bytes_);
  }

 private:
  template <typename... T>
  void add(const T&... values) {
    (add_one(values), ...);
  }
  template <typename T>
  void add_one(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add_one(value);
  }
  template <typename T, size_t n>
  void add_one(const std::array<T, n>& values) {
    for (const T& value : values) add_one(value);
  }
  template <typename T>
  requires std::is_arithmetic_v<T>
  void add_one(T value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T)); }
  void add_one(const GridKey& key) { add(key.place, key.component); }
  void add_one(const FromCell& from) { add(from.cell, from.place); }
  void add_one(const RowTiles::Row& row) { add(row.place, row.groups); }
  void add_one(const CellPart& part) { add(part.weight, part.place); }
  void add_one(const CellShare& s) { add(s.source, s.left, s.right, s.is_transposed); }
  void add_one(const CellTie& tie) {
    add(tie.first, tie.second, tie.first_corners, tie.second_corners);
  }
  void add_one(const Patches& patches) {
    add(patches.start, patches.corner, patches.colour_start, patches.entry_start);
  }
  void add_one(const HierarchyDepth& depth) {
    const SparseGrid& grid = depth.grid;
    const Stencil& stencil = depth.stencil;
    const DepthTransfer& transfer = depth.to_parent;
    add(grid.depth, depth.sheet_count, grid.cells, grid.corners, grid.cell_corners,
        grid.cells_of_corner, depth.ties, depth.parent_cell, depth.children.start,
        depth.children.item, depth.shares.part, depth.shares.target, depth.shares.start,
        depth.shares.share, depth.shares.apart);
    add(stencil.corner_of_row, stencil.row_of_corner, stencil.row_start, stencil.column,
        stencil.mask, stencil.irregular.corner, stencil.irregular.sum_start,
        stencil.irregular.source_start, stencil.irregular.source, stencil.irregular_cells.cell,
        stencil.irregular_cells.entry, stencil.tiles.row, stencil.tiles.twice_local,
        stencil.tiles.halo.start, stencil.tiles.halo.item, stencil.tiles.is_wide,
        stencil.tiles.width_max);
    add(transfer.prolongation, transfer.shared.corner, transfer.shared.start,
        transfer.shared.coarse_corner, transfer.shared.weight, transfer.restriction_start,
        transfer.restriction_corner, transfer.restriction_weight);
  }

  std::string bytes_;
};

}  // namespace burnish
