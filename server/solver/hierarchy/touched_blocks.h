#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/groups.h"
#include "server/prepare/prepared_mesh.h"
#include "server/solver/hierarchy/hierarchy.h"

// Blocks that other α of some cells touch, instead of single cells and rows (changed_parts.h). A
// device makes a whole block as fast as a part of it, and the blocks that a block reaches are known
// once the hierarchy is.

namespace burnish {

/// The blocks of one depth that a local new metric makes again. All lists rise.
struct TouchedBlocks {
  /// Numbers of parts. A coarse block has kPartsOfBlock cells, and the ties whose first cell is one
  /// of them. Block b of the finest depth has the children of block b of the depth above.
  std::vector<int32_t> parts;
  std::vector<int32_t> rows;          ///< of S
  std::vector<int32_t> inverse_rows;  ///< of M⁻¹
  std::vector<int32_t> inverses;      ///< of kCellsOfBlock cells' blocks in M⁻¹
};

/// Returns the block of a cell or tie of a coarse depth.
int32_t block_of_coarse_part(const HierarchyDepth& depth, int32_t part);

/// How the blocks of all depths hang together. Immutable; all sessions of a mesh share it.
class BlockReach {
 public:
  /// So many depths, the finest first, do not keep their numbers between metrics.
  static constexpr size_t kDepthsNotKept = 2;

  /// Needs: two depths or more. Shapes: `rows_of_block` says for each depth, the coarsest first,
  /// how many corners a block of rows has.
  BlockReach(const PreparedMesh& prepared, const Hierarchy& hierarchy,
             std::span<const int32_t> rows_of_block);

  size_t depth_count() const { return depths_.size(); }
  /// Returns how many blocks all lists of all depths have at most, and those of the finest rows.
  size_t blocks_max() const;
  size_t finest_row_blocks() const { return depths_.back().row_blocks; }

  /// Finds what other α of `cells` touch at all depths, the coarsest first. Leaves out the numbers
  /// of sheets and of the finest cells that are no child of a cell: each metric makes all of them.
  /// Shapes: cells of the finest depth in any order.
  void find(std::span<const int32_t> cells, std::vector<TouchedBlocks>& touched) const;

 private:
  struct Depth {
    // At the finest depth `all_part_blocks` counts those of cells that are no child, too.
    int32_t part_blocks = 0, all_part_blocks = 0, row_blocks = 0, cell_blocks = 0;
    // For each block of parts.
    Groups<int32_t> rows_of_parts;  // the rows that sum them
    Groups<int32_t> parts_of_rows;  // the inverse
    Groups<int32_t> above;          // parts of the depth above that sum them; none at the coarsest
    Groups<int32_t> below;          // the inverse, for each block of the depth above
    // For each block of rows.
    Groups<int32_t> rows_around;    // the rows of M⁻¹ that depend on these rows of S
    Groups<int32_t> cells_of_rows;  // the blocks of cells around them
  };

  std::vector<int32_t> block_of_finest_cell_;
  std::vector<Depth> depths_;  // the coarsest first
};

}  // namespace burnish
