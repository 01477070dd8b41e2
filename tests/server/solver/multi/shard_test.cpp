// How a scan is cut into shards: who owns what, what they have of each other, and that their
// matrices have the rows of the whole.

#include "server/solver/multi/shard.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

constexpr int32_t kWholeCorners = 500;  // corners that stay whole in these tests

const std::map<std::string, TestSystem>& cut_systems() {
  static const auto all = [] {
    std::map<std::string, TestSystem> made;
    made.try_emplace("sphere", reference::bumpy_sphere(3), 5);
    made.try_emplace("small components", reference::small_components_over_a_sphere(), 5);
    made.try_emplace("tablet", generate_scan({.kind = "tablet", .vertices = 4000}).value(), 5);
    made.try_emplace("soup", reference::shaken_soup(reference::bumpy_sphere(3), 0.01), 5);
    return made;
  }();
  return all;
}

class CuttingInto : public testing::TestWithParam<int> {
 protected:
  int shards() const { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Shards, CuttingInto, testing::Values(1, 2, 3, 4),
                         testing::PrintToStringParamName());

std::vector<ShardSets> sets_of(const Multigrid& on, const Cut& cut) {
  std::vector<ShardSets> sets;
  for (int shard = 0; shard < cut.shards; ++shard)
    sets.push_back(find_shard_sets(*on.prepared, *on.hierarchy, cut, shard));
  return sets;
}

Cut cut_of(const Multigrid& on, int shards) {
  return cut_hierarchy(*on.hierarchy, on.plan->patches, shards,
                       border_depth(*on.hierarchy, kWholeCorners));
}

TEST_P(CuttingInto, GivesEveryCornerOneOwner) {
  for (const auto& [name, on] : cut_systems()) {
    SCOPED_TRACE(name);
    const Cut cut = cut_of(on, shards());
    const std::vector<ShardSets> sets = sets_of(on, cut);
    for (int depth = cut.border; depth <= on.hierarchy->finest; ++depth) {
      std::vector<int> owners(on.hierarchy->at(depth).grid.corners.size(), 0);
      for (const ShardSets& of : sets)
        for (int32_t i = 0; i < of.at(depth).own; ++i) ++owners[of.at(depth).corners[i]];
      EXPECT_EQ(std::ranges::count(owners, 1), std::ssize(owners)) << depth;
    }
  }
}

TEST_P(CuttingInto, KeepsTheChildrenOfACellOfTheBorderTogether) {
  const TestSystem& on = cut_systems().at("sphere");
  const Cut cut = cut_of(on, shards());
  for (int depth = cut.border + 1; depth <= on.hierarchy->finest; ++depth) {
    const HierarchyDepth& of = on.hierarchy->at(depth);
    for (size_t c = 0; c < of.parent_cell.size(); ++c)
      ASSERT_EQ(cut.at(depth).cell[c], cut.at(depth - 1).cell[of.parent_cell[c]]);
  }
}

TEST_P(CuttingInto, GivesShardsAsManyCellsEach) {
  const TestSystem& on = cut_systems().at("sphere");
  const Cut cut = cut_of(on, shards());
  const std::vector<uint8_t>& owner = cut.owners.back().cell;
  for (int shard = 0; shard < shards(); ++shard)
    EXPECT_NEAR(double(std::ranges::count(owner, shard)) * shards() / double(owner.size()), 1,
                0.15);
}

int32_t patches_cut_through(const Multigrid& on, const Patches& kept_whole, int shards) {
  const Patches& patches = on.plan->patches;
  const std::vector<uint8_t> owner =
      cut_hierarchy(*on.hierarchy, kept_whole, shards, border_depth(*on.hierarchy, kWholeCorners))
          .owners.back()
          .corner;
  const auto is_cut = [&](int32_t p) {
    const auto corners = std::span(patches.corner)
                             .subspan(patches.start[p], patches.start[p + 1] - patches.start[p]);
    return std::ranges::any_of(corners, [&](int32_t i) { return owner[i] != owner[corners[0]]; });
  };
  int32_t cut_through = 0;
  for (int32_t p = 0; p < patches.count(); ++p) cut_through += is_cut(p);
  return cut_through;
}

TEST(Cutting, GoesAroundPatches) {
  constexpr int kMany = 32;
  const TestSystem& on = cut_systems().at("small components");
  EXPECT_GT(patches_cut_through(on, {}, kMany), 0);
  EXPECT_EQ(patches_cut_through(on, on.plan->patches, kMany), 0);
  int32_t in_shards = 0;
  for (const Shard& shard : make_shards(on, kMany, kWholeCorners).all)
    in_shards += shard.on.plan->patches.count();
  EXPECT_EQ(in_shards, on.plan->patches.count());
}

// On a plain surface the columns of own rows are the neighbours in the 27-stencil.
TEST(Ghosts, AreOneLayerAroundOwnCorners) {
  const TestSystem on(reference::icosphere(3, 1), 5);
  const Cut cut = cut_of(on, 3);
  const SparseGrid& grid = on.hierarchy->at(5).grid;
  for (int shard = 0; shard < 3; ++shard) {
    const ShardSets found = find_shard_sets(*on.prepared, *on.hierarchy, cut, shard);
    const DepthSets& sets = found.depths.back();
    std::set<int32_t> near;
    for (int32_t i = 0; i < sets.own; ++i)
      for (const int32_t cell : grid.cells_of_corner[sets.corners[i]])
        if (cell != kNone)
          near.insert(grid.cell_corners[cell].begin(), grid.cell_corners[cell].end());
    const std::span ghosts = std::span(sets.corners).subspan(sets.own, sets.ghosts);
    EXPECT_GT(ghosts.size(), 0u);
    for (const int32_t ghost : ghosts) EXPECT_TRUE(near.contains(ghost));
    for (const int32_t corner : near) {
      const auto own = std::span(sets.corners).first(sets.own);
      EXPECT_TRUE(std::ranges::binary_search(own, corner) ||
                  std::ranges::binary_search(ghosts, corner));
    }
  }
}

TEST_P(CuttingInto, NamesGhostsAndTheirOwnersInBothDirections) {
  for (const auto& [name, on] : cut_systems()) {
    SCOPED_TRACE(name);
    const Cut cut = cut_of(on, shards());
    const std::vector<ShardSets> sets = sets_of(on, cut);
    for (int depth = cut.border; depth <= on.hierarchy->finest; ++depth) {
      const std::vector<HaloLists> lists = find_halo_lists(cut, sets, depth);
      size_t ghosts = 0, copies = 0;
      for (int shard = 0; shard < shards(); ++shard) {
        const DepthSets& of = sets[shard].at(depth);
        ghosts += lists[shard].ghosts.size();
        copies += lists[shard].copies.item.size();
        ASSERT_EQ(std::ssize(lists[shard].ghosts), of.ghosts);
        for (int32_t i = 0; i < of.ghosts; ++i) {
          const auto [owner, index] = lists[shard].ghosts[i];
          ASSERT_EQ(sets[owner].at(depth).corners[lists[owner].sent[index]],
                    of.corners[of.own + i]);
          EXPECT_EQ(std::ranges::count(lists[owner].copies[index], HaloLists::Place{shard, i}), 1);
        }
      }
      EXPECT_EQ(ghosts, copies);
    }
  }
}

TEST(Shards, WithoutACellHaveNothingAtAnyDepth) {
  const TestSystem& on = cut_systems().at("sphere");
  Cut cut = cut_of(on, 2);
  cut.shards = 3;
  const Shard empty = make_shards(on, cut).all[2];
  EXPECT_EQ(empty.own_corners, 0);
  EXPECT_TRUE(empty.cells.empty());
  EXPECT_TRUE(empty.vertices.empty());
  for (const HierarchyDepth& depth : empty.on.hierarchy->depths)
    EXPECT_EQ(depth.grid.corner_count(), 0);
}

TEST_P(CuttingInto, GivesEachVertexToOneShard) {
  const TestSystem on(reference::sphere_with_debris(3), 5);
  std::vector<int> shards_of(on.prepared->evaluation.size(), 0);
  for (const Shard& shard : make_shards(on, shards(), kWholeCorners).all) {
    ASSERT_EQ(shard.vertices.size(), shard.on.prepared->evaluation.size());
    for (size_t i = 0; i < shard.vertices.size(); ++i) {
      ++shards_of[shard.vertices[i]];
      EXPECT_EQ(shard.cells[shard.on.prepared->evaluation[i].cell],
                on.prepared->evaluation[shard.vertices[i]].cell);
    }
  }
  for (size_t v = 0; v < shards_of.size(); ++v)
    EXPECT_EQ(shards_of[v], on.prepared->evaluation[v].cell == kNone ? 0 : 1);
}

// Maps a shard's corners of one depth to those of the whole.
std::vector<int32_t> corners_of(const TestSystem& on, int shards, int shard, int depth) {
  return find_shard_sets(*on.prepared, *on.hierarchy, cut_of(on, shards), shard).at(depth).corners;
}

// A shard's rows, and its prolongation, have the columns of the whole.
TEST_P(CuttingInto, KeepsTheColumnsOfOwnRowsAndOfGhosts) {
  for (const auto& [name, on] : cut_systems()) {
    SCOPED_TRACE(name);
    const Shards cut = make_shards(on, shards(), kWholeCorners);
    for (int number = 0; number < shards(); ++number)
      for (int depth = cut.border + 1; depth <= on.hierarchy->finest; ++depth) {
        const HierarchyDepth &of = cut.all[number].on.hierarchy->at(depth),
                             &whole = on.hierarchy->at(depth);
        const std::vector<int32_t> corners = corners_of(on, shards(), number, depth);
        const auto columns = [](const Stencil& stencil, int32_t row) {
          const auto [begin, end] = stencil.row(row);
          return std::vector<int32_t>(stencil.column.begin() + begin, stencil.column.begin() + end);
        };
        for (int32_t i = 0; i < of.known_count(); ++i) {
          std::vector<int32_t> here = columns(of.stencil, i);
          for (int32_t& column : here) column = corners[column];
          std::vector<int32_t> there = columns(whole.stencil, corners[i]);
          std::ranges::sort(here);
          std::ranges::sort(there);
          ASSERT_EQ(here, there) << "depth " << depth << " corner " << i;
        }
        for (int32_t i = 0; i < of.own_count(); ++i)
          ASSERT_EQ(of.to_parent.is_shared(i), whole.to_parent.is_shared(corners[i]));
      }
  }
}

}  // namespace
}  // namespace burnish
