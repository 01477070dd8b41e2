#include "server/solver/hierarchy/patches.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "server/solver/tuning/plan_cycle.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

const TestSystem& small_components() {
  static const TestSystem made(reference::small_components_over_a_sphere(), 5);
  return made;
}

const HierarchyDepth& finest_of(const TestSystem& system) {
  return system.hierarchy->at(system.hierarchy->finest);
}

std::vector<int32_t> corners_of(const Patches& patches, int32_t patch) {
  return {patches.corner.begin() + patches.start[patch],
          patches.corner.begin() + patches.start[patch + 1]};
}

TEST(Patches, ASurfaceOfOnePieceHasNone) {
  const TestSystem system(reference::bumpy_sphere(4), 6);
  EXPECT_EQ(system.plan->patches.count(), 0);
  EXPECT_EQ(system.plan->patches.colour_count(), 0);
}

TEST(Patches, SheetsThatAreKeptTogetherHaveNone) {
  const auto together = make_hierarchy(*small_components().prepared, Sheets::kTogether);
  EXPECT_EQ(plan_cycle(small_components().prepared, together).value()->patches.count(), 0);
}

TEST(Patches, HaveFewCornersEachOfThemOnce) {
  const Patches& patches = small_components().plan->patches;
  ASSERT_GT(patches.count(), 20);
  for (int32_t patch = 0; patch < patches.count(); ++patch) {
    const std::vector<int32_t> corners = corners_of(patches, patch);
    EXPECT_GE(corners.size(), kCornersPerCell);
    EXPECT_LE(corners.size(), kPatchCornersMax);
    EXPECT_TRUE(std::ranges::adjacent_find(corners, std::greater_equal<>()) == corners.end());
    EXPECT_EQ(patches.entry_start[patch + 1] - patches.entry_start[patch],
              static_cast<int64_t>(corners.size() * (corners.size() + 1) / 2));
  }
}

TEST(Patches, OfAColourShareNoCell) {
  const HierarchyDepth& finest = finest_of(small_components());
  const Patches& patches = small_components().plan->patches;
  ASSERT_GT(patches.colour_count(), 1);
  EXPECT_EQ(patches.colour_start.back(), patches.count());
  for (int32_t colour = 0; colour < patches.colour_count(); ++colour) {
    std::set<int32_t> cells_of_others;
    for (int32_t p = patches.colour_start[colour]; p < patches.colour_start[colour + 1]; ++p) {
      std::set<int32_t> cells;
      for (const int32_t corner : corners_of(patches, p))
        for (const int32_t cell : finest.grid.cells_of_corner[corner])
          if (cell != kNone) cells.insert(cell);
      for (const int32_t cell : cells) EXPECT_TRUE(cells_of_others.insert(cell).second);
    }
  }
}

TEST(Patches, HaveNoMoreEntriesThanTheirShareOfTheMatrix) {
  EXPECT_LE(small_components().plan->patches.entry_count(),
            24 * finest_of(small_components()).grid.corner_count());
}

}  // namespace
}  // namespace burnish
