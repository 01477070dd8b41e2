#include "server/solver/hierarchy/touched_blocks.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"
#include "server/solver/hierarchy/block_sizes.h"
#include "server/solver/hierarchy/index_set.h"
#include "server/solver/hierarchy/sources.h"

namespace burnish {

namespace {

constexpr int32_t kApartOfBlock = 64;  // finest cells that are no child of a cell

int32_t blocks_of(int64_t items, int32_t of_block) {
  return static_cast<int32_t>((items + of_block - 1) / of_block);
}

void drop_repeated(std::vector<int32_t>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Returns for each of `from` blocks which other blocks visit(block, add) adds, rising.
template <typename Visit>
Groups<int32_t> relate(int32_t from, const Visit& visit) {
  std::vector<std::vector<int32_t>> reached(from);
  ParallelFailure failure;
#pragma omp parallel
  {
    std::vector<int32_t> added;  // often again: the same block has many ways to another
#pragma omp for schedule(dynamic, 64)
    for (int32_t block = 0; block < from; ++block) {
      failure.run([&] {
        added.clear();
        visit(block, [&](int32_t other) { added.push_back(other); });
        drop_repeated(added);
        reached[block] = added;
      });
    }
  }
  failure.rethrow();
  Groups<int32_t> related;
  for (const std::vector<int32_t>& blocks : reached) related.add(blocks);
  return related;
}

Groups<int32_t> inverse_of(const Groups<int32_t>& relation, int32_t to) {
  return group_by<int32_t>(to, [&](auto&& add) {
    for (size_t from = 0; from < relation.count(); ++from)
      for (const int32_t other : relation[from]) add(other, static_cast<int32_t>(from));
  });
}

/// The parts of one depth by blocks.
class PartBlocks {
 public:
  /// `above`: null at the coarsest depth.
  PartBlocks(const PreparedMesh& prepared, const HierarchyDepth& depth, const HierarchyDepth* above,
             std::span<const int32_t> block_of_finest_cell)
      : prepared_(prepared), depth_(depth), above_(above), of_finest_cell_(block_of_finest_cell) {}

  /// Returns the number of blocks but those of cells that are no child.
  int32_t count() const {
    return blocks_of((depth_.is_finest() ? above_->grid : depth_.grid).cell_count(), kPartsOfBlock);
  }
  int32_t count_of_all() const {
    return count() +
           (depth_.is_finest() ? blocks_of(std::ssize(above_->shares.apart), kApartOfBlock) : 0);
  }

  int32_t of_part(int32_t part) const {
    if (!depth_.is_finest()) return block_of_coarse_part(depth_, part);
    const int32_t sheet = part - depth_.grid.cell_count();
    return of_finest_cell_[sheet < 0 ? part : prepared_.sheets[sheet].cell];
  }

  /// Calls visit(cell) for the cells of a block.
  template <typename Visit>
  void visit_cells(int32_t block, Visit&& visit) const {
    const auto& parents = depth_.is_finest() ? above_->grid : depth_.grid;
    const int32_t first = block * kPartsOfBlock;
    const int32_t end = std::min(first + kPartsOfBlock, parents.cell_count());
    if (!depth_.is_finest())
      for (int32_t cell = first; cell < end; ++cell) visit(cell);
    else if (block < count())
      for (int32_t parent = first; parent < end; ++parent)
        for (const int32_t child : above_->children[parent]) visit(child);
    else
      for (const int32_t cell : apart_cells(block - count())) visit(cell);
  }

  /// Calls visit(cell) for the cells whose corners' rows sum the block's parts.
  template <typename Visit>
  void visit_summed_cells(int32_t block, Visit&& visit) const {
    visit_cells(block, visit);
    const int32_t first = block * kPartsOfBlock;
    auto tie = std::ranges::lower_bound(depth_.ties, first, {}, &CellTie::first);
    for (; tie != depth_.ties.end() && tie->first < first + kPartsOfBlock; ++tie) {
      visit(tie->first);
      visit(tie->second);
    }
  }

 private:
  std::span<const int32_t> apart_cells(int32_t block) const {
    const auto rest = std::span(above_->shares.apart).subspan(size_t{kApartOfBlock} * block);
    return rest.first(std::min(rest.size(), size_t{kApartOfBlock}));
  }

  const PreparedMesh& prepared_;
  const HierarchyDepth& depth_;
  const HierarchyDepth* above_;
  std::span<const int32_t> of_finest_cell_;
};

// Cells that are no child have the last blocks.
std::vector<int32_t> blocks_of_finest_cells(const HierarchyDepth& finest,
                                            const HierarchyDepth& above) {
  std::vector<int32_t> block(finest.grid.cells.size());
  const int32_t first_apart = blocks_of(above.grid.cell_count(), kPartsOfBlock);
  for (size_t i = 0; i < above.shares.apart.size(); ++i)
    block[above.shares.apart[i]] = first_apart + static_cast<int32_t>(i) / kApartOfBlock;
  for (int32_t parent = 0; parent < above.grid.cell_count(); ++parent)
    for (const int32_t child : above.children[parent]) block[child] = parent / kPartsOfBlock;
  return block;
}

Groups<int32_t> find_rows_of_parts(const HierarchyDepth& depth, const PartBlocks& parts,
                                   int32_t rows_of_block) {
  return relate(parts.count_of_all(), [&](int32_t block, auto&& add) {
    parts.visit_summed_cells(block, [&](int32_t cell) {
      for (const int32_t corner : depth.grid.cell_corners[cell]) add(corner / rows_of_block);
    });
  });
}

// Returns the cells around the corners of each block of rows.
Groups<int32_t> find_cells_of_rows(const HierarchyDepth& depth, int32_t rows_of_block,
                                   int32_t row_blocks) {
  return relate(row_blocks, [&](int32_t block, auto&& add) {
    const int32_t first = block * rows_of_block;
    const int32_t end = std::min(first + rows_of_block, depth.grid.corner_count());
    for (int32_t corner = first; corner < end; ++corner)
      visit_parts_of_row(depth, corner, [&](int32_t part) {
        if (part < depth.grid.cell_count()) add(part);
      });
  });
}

Groups<int32_t> find_rows_around(const HierarchyDepth& depth, const Groups<int32_t>& cells,
                                 int32_t rows_of_block) {
  const auto blocks = static_cast<int32_t>(cells.count());
  return relate(blocks, [&](int32_t block, auto&& add) {
    for (const int32_t cell : cells[block])
      for (const int32_t corner : depth.grid.cell_corners[cell]) add(corner / rows_of_block);
  });
}

Groups<int32_t> find_cell_blocks(const Groups<int32_t>& cells) {
  return relate(static_cast<int32_t>(cells.count()), [&](int32_t block, auto&& add) {
    for (const int32_t cell : cells[block]) add(cell / kCellsOfBlock);
  });
}

// Returns the blocks of the finer depth for each block of the coarse one.
Groups<int32_t> find_below(const PartBlocks& fine, const HierarchyDepth& coarse,
                           const PartBlocks& of_coarse) {
  const CellShares& shares = coarse.shares;
  const auto targets = group_by<int32_t>(of_coarse.count(), [&](auto&& add) {
    for (size_t i = 0; i < shares.target.size(); ++i)
      add(block_of_coarse_part(coarse, shares.target[i]), static_cast<int32_t>(i));
  });
  return relate(of_coarse.count(), [&](int32_t block, auto&& add) {
    of_coarse.visit_cells(block, [&](int32_t cell) {
      for (const int32_t child : coarse.children[cell]) add(fine.of_part(child));
    });
    for (const int32_t i : targets[block])
      for (int32_t k = shares.start[i]; k < shares.start[i + 1]; ++k)
        add(fine.of_part(shares.share[k].source));
  });
}

/// Adds the blocks that these ones reach.
void add_reached(const Groups<int32_t>& relation, std::span<const int32_t> blocks, IndexSet& to) {
  for (const int32_t block : blocks)
    for (const int32_t other : relation[block]) to.insert(other);
}

std::vector<int32_t> reached(const Groups<int32_t>& relation, std::span<const int32_t> blocks,
                             int32_t bound) {
  IndexSet others(bound);
  add_reached(relation, blocks, others);
  return others.take_rising();
}

}  // namespace

int32_t block_of_coarse_part(const HierarchyDepth& depth, int32_t part) {
  const int32_t tie = part - depth.grid.cell_count();
  return (tie < 0 ? part : depth.ties[tie].first) / kPartsOfBlock;
}

BlockReach::BlockReach(const PreparedMesh& prepared, const Hierarchy& hierarchy,
                       std::span<const int32_t> rows_of_block)
    : depths_(hierarchy.depths.size()) {
  const std::vector<HierarchyDepth>& depths = hierarchy.depths;
  block_of_finest_cell_ = blocks_of_finest_cells(depths.back(), depths[depths.size() - 2]);
  const auto parts_of = [&](size_t d) {
    return PartBlocks(prepared, depths[d], d > 0 ? &depths[d - 1] : nullptr, block_of_finest_cell_);
  };
  for (size_t d = 0; d < depths.size(); ++d) {
    const PartBlocks parts = parts_of(d);
    const int32_t rows = rows_of_block[d];
    Depth& made = depths_[d];
    made.part_blocks = parts.count();
    made.all_part_blocks = parts.count_of_all();
    made.row_blocks = blocks_of(depths[d].grid.corner_count(), rows);
    made.cell_blocks = blocks_of(depths[d].grid.cell_count(), kCellsOfBlock);
    made.rows_of_parts = find_rows_of_parts(depths[d], parts, rows);
    made.parts_of_rows = inverse_of(made.rows_of_parts, made.row_blocks);
    const Groups<int32_t> around = find_cells_of_rows(depths[d], rows, made.row_blocks);
    made.rows_around = find_rows_around(depths[d], around, rows);
    made.cells_of_rows = find_cell_blocks(around);
    if (d == 0) continue;
    made.below = find_below(parts, depths[d - 1], parts_of(d - 1));
    made.above = inverse_of(made.below, parts.count_of_all());
  }
}

size_t BlockReach::blocks_max() const {
  size_t blocks = 0;
  for (const Depth& depth : depths_)
    blocks += depth.part_blocks + size_t{2} * depth.row_blocks + depth.cell_blocks;
  return blocks;
}

void BlockReach::find(std::span<const int32_t> cells, std::vector<TouchedBlocks>& touched) const {
  const size_t finest = depths_.size() - 1;
  touched.resize(depths_.size());
  IndexSet of_cells(depths_[finest].all_part_blocks);
  for (const int32_t cell : cells) of_cells.insert(block_of_finest_cell_[cell]);
  touched[finest].parts = of_cells.take_rising();
  for (size_t d = finest + 1; d-- > 0;) {
    const Depth& depth = depths_[d];
    TouchedBlocks& here = touched[d];
    if (d < finest)
      here.parts = reached(depths_[d + 1].above, touched[d + 1].parts, depth.part_blocks);
    here.rows = reached(depth.rows_of_parts, here.parts, depth.row_blocks);
    here.inverse_rows = reached(depth.rows_around, here.rows, depth.row_blocks);
    here.inverses = reached(depth.cells_of_rows, here.inverse_rows, depth.cell_blocks);
  }
  // Depths without kept numbers also need what their rows and the depth above sum.
  for (size_t d = finest + 1 - std::min(kDepthsNotKept, depths_.size()); d <= finest; ++d) {
    const Depth& depth = depths_[d];
    IndexSet needed(depth.all_part_blocks);
    for (const int32_t block : touched[d].parts) needed.insert(block);
    add_reached(depth.parts_of_rows, touched[d].rows, needed);
    if (d > 0) add_reached(depth.below, touched[d - 1].parts, needed);
    if (d == finest)
      for (const int32_t block : touched[d - 1].parts) needed.insert(block);
    touched[d].parts = needed.take_rising();
  }
  std::vector<int32_t>& of_finest = touched[finest].parts;
  of_finest.erase(std::ranges::lower_bound(of_finest, depths_[finest].part_blocks),
                  of_finest.end());
}

}  // namespace burnish
