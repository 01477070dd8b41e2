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
#include "server/solver/hierarchy/points_by_cell.h"
#include "server/solver/hierarchy/sheets/cell_shares.h"
#include "server/solver/hierarchy/stencil.h"

namespace burnish {

/// One depth of the multigrid hierarchy, without any number that depends on the metric.
struct HierarchyDepth {
  SparseGrid grid;
  Stencil stencil;
  std::vector<CellTie> ties;         ///< rising; none at the finest depth
  int32_t sheet_count = 0;           ///< PreparedMesh::sheets that are used; none at coarse depths
  DepthTransfer to_parent;           ///< empty at the coarsest depth
  std::vector<int32_t> parent_cell;  ///< one per cell; empty at the coarsest depth
  // Where the numbers of cells and ties come from; empty at the finest depth.
  Groups<int32_t> children;  ///< of each cell, cells of the finer depth, at most eight, each
                             ///< in an octant: their numbers are restricted by it alone
  CellShares shares;         ///< all else

  bool is_finest() const { return children.count() == 0; }

  /// How many numbers its cells, ties and sheets have: see number_of_tie().
  size_t number_count() const {
    return kNumbersPerCell * grid.cells.size() + kNumbersPerTie * (ties.size() + sheet_count);
  }
};

/// All depths of one prepared mesh, immutable and shared by its sessions.
struct Hierarchy {
  int coarsest = 0;  ///< solved directly
  int finest = 0;
  std::vector<HierarchyDepth> depths;  ///< depths[d - coarsest]
  PointsByCell points;                 ///< the vertices, by cells of the finest depth

  const HierarchyDepth& at(int depth) const { return depths[depth - coarsest]; }
  uint64_t byte_count() const;
};

/// The coarsest depth is the deepest one with at most this many corners, or kCoarsestDepthMin:
/// every separate piece of surface keeps eight corners at any depth.
inline constexpr int32_t kCoarsestCornersMax = 600;
inline constexpr int kCoarsestDepthMin = 2;

/// What coarse depths make of sheets of surface that come closer to each other than their cells.
enum class Sheets {
  /// A cell or corner for each sheet, as far as it does not hang together with the others nearby.
  /// Where sheets meet in a corner of the finest depth without hanging together, that takes their
  /// mean, and ties couple their cells (the Galerkin product PᵀSP, as everywhere). Of a soup, where
  /// too many corners are such, sheets come apart only above the finest depth.
  kApart,
  /// One for all sheets of a piece of surface, of which any two cells are connected by cells that
  /// share a corner. Rows have at most 27 entries, and corners of one parity no entry with each
  /// other: what point smoothers need.
  kTogether,
};

/// Fails: cancelled.
Result<std::shared_ptr<const Hierarchy>> make_hierarchy(const PreparedMesh& prepared,
                                                        const Progress& progress,
                                                        Sheets sheets = Sheets::kApart);

/// The same for whoever cannot be cancelled.
inline std::shared_ptr<const Hierarchy> make_hierarchy(const PreparedMesh& prepared,
                                                       Sheets sheets = Sheets::kApart) {
  return make_hierarchy(prepared, Progress(), sheets).value();
}

}  // namespace burnish
