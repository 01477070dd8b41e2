#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "common/grid/stencil_slots.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Which corners share a cell, itself left out: the off-diagonal pattern of every matrix of one
/// depth, in compressed rows.
///
/// Among each kRowWindow corners the rows are stored by rising length, so that a loop over rows
/// seldom meets another length than before (a mispredicted end costs as much as a row), and each
/// is padded to a multiple of kRowPadding entries by the corner itself, whose entry is zero there.
struct Stencil {
  static constexpr int32_t kRowWindow = 256;
  static constexpr int kRowPadding = 4;

  std::vector<int32_t> corner_of_row;
  std::vector<int32_t> row_of_corner;
  std::vector<int64_t> row_start;  ///< rows + 1
  std::vector<int32_t> column;     ///< in slot order within a row
  std::vector<uint32_t> mask;      ///< bit s of mask[I]: slot s of corner I is present

  struct Row {
    int64_t begin, end;
  };
  /// The places of a corner's entries in `column`, padding left out.
  Row row(int32_t corner) const {
    const int64_t begin = row_start[row_of_corner[corner]];
    return {begin, begin + __builtin_popcount(mask[corner])};
  }
  /// Where slot s of corner I stands in `column`. Needs: the slot is present.
  int64_t position(int32_t corner, int slot) const {
    return row_start[row_of_corner[corner]] + __builtin_popcount(mask[corner] & ((1u << slot) - 1));
  }
};

/// Prolongation P and restriction Pᵀ between a depth and the one above (coarser), trilinear.
struct DepthTransfer {
  /// A fine corner lies in coarse cell `cell`, at position `place` of its 3×3×3 half-way points.
  struct FromCell {
    int32_t cell;
    uint8_t place;
  };
  std::vector<FromCell> prolongation;       ///< one per fine corner
  std::vector<int64_t> restriction_start;   ///< coarse corners + 1
  std::vector<int32_t> restriction_corner;  ///< the fine corners that a coarse corner gathers
  std::vector<float> restriction_weight;    ///< 1, 1/2, 1/4 or 1/8
};

/// The weights of a cell's eight corners at each of its 27 half-way points.
const std::array<std::array<float, kCornersPerCell>, kSlots>& half_way_weights();

/// One depth of the multigrid hierarchy, without any number that depends on the metric.
struct HierarchyDepth {
  SparseGrid grid;
  Stencil stencil;
  DepthTransfer to_parent;           ///< empty at the coarsest depth
  std::vector<int32_t> parent_cell;  ///< one per cell; empty at the coarsest depth
  std::vector<int32_t> child_start;  ///< cells + 1, into `child`; empty at the finest depth
  std::vector<int32_t> child;        ///< cells of the finer depth
};

/// All depths of one prepared mesh, immutable and shared by its sessions.
struct Hierarchy {
  int coarsest = 0;  ///< solved directly
  int finest = 0;
  std::vector<HierarchyDepth> depths;  ///< depths[d - coarsest]

  const HierarchyDepth& at(int depth) const { return depths[depth - coarsest]; }
  uint64_t byte_count() const;
};

/// The coarsest depth is the deepest one with at most this many corners, or kCoarsestDepthMin:
/// every separate piece of surface keeps eight corners at any depth.
inline constexpr int32_t kCoarsestCornersMax = 600;
inline constexpr int kCoarsestDepthMin = 2;

std::shared_ptr<const Hierarchy> make_hierarchy(const PreparedMesh& prepared);

}  // namespace burnish
