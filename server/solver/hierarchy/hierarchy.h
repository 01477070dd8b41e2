#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/base/groups.h"
#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/hierarchy/depth_transfer.h"
#include "server/solver/hierarchy/patches.h"
#include "server/solver/hierarchy/points_by_cell.h"
#include "server/solver/hierarchy/sheets/cell_shares.h"
#include "server/solver/hierarchy/stencil.h"

namespace burnish {

/// One depth of the multigrid hierarchy, without any number that depends on the metric.
struct HierarchyDepth {
  SparseGrid grid;
  Stencil stencil;
  std::vector<CellTie> ties;         ///< rising; none at the finest depth
  int32_t sheet_count = 0;           ///< PreparedMesh::sheets in use; 0 at coarse depths
  DepthTransfer to_parent;           ///< empty at the coarsest depth
  std::vector<int32_t> parent_cell;  ///< one per cell; empty at the coarsest depth. kNone in a
                                     ///< small component, and in a shard for a parent that the
                                     ///< shard has not
  // The sources of the numbers of cells and ties; empty at the finest depth.
  Groups<int32_t> children;  ///< cells of the finer depth for each cell, at most eight, each in its
                             ///< octant; only that octant restricts its numbers
  CellShares shares;         ///< all other sources

  // In a shard of a scan (solver/multi) its own corners come first, then ghosts, then the fringe.
  int32_t ghost_count = 0;   ///< corners whose values come from other shards
  int32_t fringe_count = 0;  ///< corners that only complete cells: they are pinned

  int32_t own_count() const { return grid.corner_count() - ghost_count - fringe_count; }
  int32_t known_count() const { return grid.corner_count() - fringe_count; }

  bool is_finest() const { return children.count() == 0; }

  /// Returns how many numbers its cells, ties and sheets have; see number_of_tie().
  size_t number_count() const {
    return kNumbersPerCell * grid.cells.size() + kNumbersPerTie * (ties.size() + sheet_count);
  }
};

/// All depths of one prepared mesh. Immutable; its sessions share it.
struct Hierarchy {
  int coarsest = 0;  ///< solved directly
  int finest = 0;
  std::vector<HierarchyDepth> depths;  ///< depths[d - coarsest]
  PointsByCell points;                 ///< the vertices, by cells of the finest depth
  /// The small components of the finest depth that no coarse depth knows. The cycle must solve them
  /// as a whole. If each had coarse corners of its own, hundreds of small components would make the
  /// direct solve of the coarsest depth the longest part of a new metric.
  Patches small_components;

  const HierarchyDepth& at(int depth) const { return depths[depth - coarsest]; }
  uint64_t byte_count() const;
};

/// The coarsest depth is the deepest one with at most this many corners, or kCoarsestDepthMin.
/// Every separate piece of surface but small components keeps eight corners at any depth.
inline constexpr int32_t kCoarsestCornersMax = 600;
inline constexpr int kCoarsestDepthMin = 2;

/// Says how coarse depths treat sheets of surface that come closer to each other than their cells.
enum class Sheets {
  /// Gives each sheet its own cell or corner unless it hangs together with the others nearby. If
  /// sheets meet in a corner of the finest depth without hanging together, the corner takes their
  /// mean, and ties couple their cells (the Galerkin product PᵀSP, as everywhere). In a soup too
  /// many corners are such: its sheets come apart only above the finest depth.
  kApart,
  /// Gives all sheets of a piece of surface one cell or corner. Cells that share a corner connect
  /// any two cells of a piece. Rows have at most 27 entries, and corners of one parity have no
  /// entry with each other: point smoothers need this.
  kTogether,
};

/// Fails: cancelled.
Result<std::shared_ptr<const Hierarchy>> make_hierarchy(const PreparedMesh& prepared,
                                                        const Progress& progress,
                                                        Sheets sheets = Sheets::kApart);

/// Makes a hierarchy when nobody can cancel it.
inline std::shared_ptr<const Hierarchy> make_hierarchy(const PreparedMesh& prepared,
                                                       Sheets sheets = Sheets::kApart) {
  return make_hierarchy(prepared, Progress(), sheets).value();
}

}  // namespace burnish
