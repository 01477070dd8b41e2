// The blocks of a local new metric have all that changes, and all that it is made of.

#include "server/solver/hierarchy/touched_blocks.h"

#include <algorithm>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/solver/hierarchy/block_sizes.h"
#include "server/solver/hierarchy/changed_parts.h"
#include "server/solver/hierarchy/sources.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

constexpr int32_t kRowsOfBlock = 128, kRowsOfCoarseBlock = 32;

bool has(const std::vector<int32_t>& blocks, int32_t block) {
  return std::ranges::binary_search(blocks, block);
}

/// A system with its reach. Coarse depths have smaller blocks of rows, as depths with long rows do.
struct Reached : TestSystem {
  Reached(const TriangleMesh& mesh, int depth)
      : TestSystem(mesh, depth),
        rows_of_block(hierarchy->depths.size(), kRowsOfCoarseBlock),
        reach(*prepared, *hierarchy, with_large_blocks()),
        block_of_finest(hierarchy->depths.back().grid.cells.size(), kNone) {
    const HierarchyDepth& above = hierarchy->depths[hierarchy->depths.size() - 2];
    for (int32_t parent = 0; parent < above.grid.cell_count(); ++parent)
      for (const int32_t child : above.children[parent])
        block_of_finest[child] = parent / kPartsOfBlock;
  }

  const std::vector<int32_t>& with_large_blocks() {
    rows_of_block.back() = kRowsOfBlock;
    return rows_of_block;
  }

  /// Returns whether the part's numbers are there: made again, made each time or kept.
  bool has_numbers(size_t d, int32_t part, const TouchedBlocks& touched) const {
    const HierarchyDepth& depth = hierarchy->depths[d];
    if (hierarchy->depths.size() - d > BlockReach::kDepthsNotKept) return true;
    if (!depth.is_finest()) return has(touched.parts, block_of_coarse_part(depth, part));
    const bool is_made_each_time =
        part >= depth.grid.cell_count() || block_of_finest[part] == kNone;
    return is_made_each_time || has(touched.parts, block_of_finest[part]);
  }

  std::vector<int32_t> rows_of_block;
  BlockReach reach;
  std::vector<int32_t> block_of_finest;  // kNone for a cell that is no child
};

std::vector<int32_t> cells_near_one(const PreparedMesh& prepared, int radius,
                                    std::minstd_rand& random) {
  const auto count = static_cast<int32_t>(prepared.cells.size());
  const Vec3i middle = morton_point(prepared.cells[random() % count]);
  std::vector<int32_t> cells;
  for (int32_t c = 0; c < count; ++c)
    if ((morton_point(prepared.cells[c]) - middle).cwiseAbs().maxCoeff() <= radius)
      cells.push_back(c);
  return cells;
}

void expect_all_that_changes(const Reached& on, const std::vector<int32_t>& cells,
                             const std::vector<TouchedBlocks>& touched) {
  const auto changed = find_changed_parts(*on.prepared, *on.hierarchy, cells, 0);
  for (size_t d = 0; d < touched.size(); ++d) {
    const HierarchyDepth& depth = on.hierarchy->depths[d];
    const int32_t rows = on.rows_of_block[d];
    SCOPED_TRACE("depth " + std::to_string(depth.grid.depth));
    for (const int32_t part : changed[d].parts) {
      const bool is_made = depth.is_finest()
                               ? on.has_numbers(d, part, touched[d])
                               : has(touched[d].parts, block_of_coarse_part(depth, part));
      EXPECT_TRUE(is_made) << part;
    }
    for (const int32_t row : changed[d].rows) EXPECT_TRUE(has(touched[d].rows, row / rows)) << row;
    const CellsAround around = find_cells_around(depth, changed[d].rows);
    for (const int32_t row : around.corners)
      EXPECT_TRUE(has(touched[d].inverse_rows, row / rows)) << row;
  }
}

// Every listed row has the numbers that it sums, and the listed parts of a depth have theirs.
void expect_all_sources(const Reached& on, const std::vector<TouchedBlocks>& touched) {
  for (size_t d = 0; d < touched.size(); ++d) {
    const HierarchyDepth& depth = on.hierarchy->depths[d];
    const int32_t rows = on.rows_of_block[d];
    SCOPED_TRACE("depth " + std::to_string(depth.grid.depth));
    for (int32_t row = 0; row < depth.grid.corner_count(); ++row)
      visit_parts_of_row(depth, row, [&](int32_t part) {
        if (has(touched[d].rows, row / rows)) {
          EXPECT_TRUE(on.has_numbers(d, part, touched[d])) << row << ' ' << part;
        }
        const bool is_cell = part < depth.grid.cell_count();
        if (is_cell && has(touched[d].inverse_rows, row / rows)) {
          EXPECT_TRUE(has(touched[d].inverses, part / kCellsOfBlock)) << row << ' ' << part;
        }
      });
    if (depth.is_finest()) continue;
    for (int32_t part = 0; part < static_cast<int32_t>(part_count(depth)); ++part)
      if (has(touched[d].parts, block_of_coarse_part(depth, part)))
        visit_sources(depth, part, [&](int32_t source) {
          EXPECT_TRUE(on.has_numbers(d + 1, source, touched[d + 1])) << part << ' ' << source;
        });
  }
}

void expect_whole_reach(const TriangleMesh& mesh, int depth) {
  const Reached on(mesh, depth);
  std::minstd_rand random(5);
  std::vector<TouchedBlocks> touched;
  for (const int radius : {0, 1, 4}) {
    SCOPED_TRACE("radius " + std::to_string(radius));
    const std::vector<int32_t> cells = cells_near_one(*on.prepared, radius, random);
    on.reach.find(cells, touched);
    expect_all_that_changes(on, cells, touched);
    expect_all_sources(on, touched);
  }
}

TEST(TouchedBlocks, HaveAllThatChangesAndItsSourcesOnAwkwardScans) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    expect_whole_reach(mesh, 6);
  }
}

TEST(TouchedBlocks, HaveAllThatChangesWhereCellsHaveTiesAndSheets) {
  expect_whole_reach(generate_scan({.kind = "wall", .vertices = 10'000}).value(), 6);
  expect_whole_reach(reference::small_components_over_a_sphere(), 6);
  expect_whole_reach(reference::several_components(), 7);
}

TEST(TouchedBlocks, OfNoCellAreNone) {
  const Reached on(reference::bumpy_sphere(4), 6);
  std::vector<TouchedBlocks> touched;
  on.reach.find({}, touched);
  ASSERT_EQ(touched.size(), on.hierarchy->depths.size());
  for (const TouchedBlocks& depth : touched) {
    EXPECT_TRUE(depth.parts.empty() && depth.rows.empty());
    EXPECT_TRUE(depth.inverse_rows.empty() && depth.inverses.empty());
  }
}

TEST(TouchedBlocks, OfOneCellAreFewAndRise) {
  const Reached on(reference::bumpy_sphere(5), 8);
  const std::vector<int32_t> cell = {1017};
  std::vector<TouchedBlocks> touched;
  on.reach.find(cell, touched);
  const TouchedBlocks& finest = touched.back();
  EXPECT_LE(finest.rows.size(), 20u);
  EXPECT_LE(finest.parts.size(), 50u);
  size_t blocks = 0;
  for (const TouchedBlocks& depth : touched) {
    for (const auto* list : {&depth.parts, &depth.rows, &depth.inverse_rows, &depth.inverses}) {
      EXPECT_TRUE(std::ranges::adjacent_find(*list, std::greater_equal<>()) == list->end());
      blocks += list->size();
    }
  }
  EXPECT_LT(blocks, on.reach.blocks_max() / 4);
}

TEST(TouchedBlocks, OfAllCellsAreAllThatThereIsRoomFor) {
  const Reached on(reference::bumpy_sphere(4), 6);
  std::vector<int32_t> cells(on.prepared->cells.size());
  for (size_t c = 0; c < cells.size(); ++c) cells[c] = static_cast<int32_t>(c);
  std::vector<TouchedBlocks> touched;
  on.reach.find(cells, touched);
  size_t blocks = 0;
  for (const TouchedBlocks& depth : touched)
    blocks +=
        depth.parts.size() + depth.rows.size() + depth.inverse_rows.size() + depth.inverses.size();
  EXPECT_EQ(blocks, on.reach.blocks_max());
}

}  // namespace
}  // namespace burnish
