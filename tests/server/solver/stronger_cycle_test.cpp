#include "server/solver/stronger_cycle.h"

#include <gtest/gtest.h>

#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

std::vector<int> depths_corrected_twice(const Hierarchy& hierarchy) {
  std::vector<int> depths;
  for (const HierarchyDepth& depth : hierarchy.depths)
    if (depth.is_corrected_twice) depths.push_back(depth.grid.depth);
  return depths;
}

TEST(StrongerCycle, LeavesAScanWithoutNearSheetsAsItIs) {
  const TestSystem system(reference::bumpy_sphere(4), 6);
  EXPECT_TRUE(depths_corrected_twice(*system.hierarchy).empty());
  EXPECT_EQ(system.hierarchy->depths.back().patches.count(), 0);
}

TEST(StrongerCycle, CorrectsTwoDepthsTwiceWhereSheetsComeTogether) {
  const TestSystem system(reference::spiked_sphere(), 6);
  EXPECT_EQ(depths_corrected_twice(*system.hierarchy), (std::vector{4, 5}));
}

TEST(StrongerCycle, NeverCorrectsTheCoarsestDepth) {
  const TestSystem system(reference::spiked_sphere(), 5);
  EXPECT_EQ(system.hierarchy->coarsest, 3);
  EXPECT_EQ(depths_corrected_twice(*system.hierarchy), std::vector{4});
}

TEST(StrongerCycle, PutsPatchesWhereATrialIsSlow) {
  const TestSystem system(reference::spiked_sphere(), 6);
  EXPECT_GT(system.hierarchy->depths.back().patches.count(), 50);
}

TEST(StrongerCycle, LeavesSheetsThatAreKeptTogetherAsTheyAre) {
  const TestSystem system(reference::spiked_sphere(), 6);
  const auto together = make_hierarchy(*system.prepared, Sheets::kTogether);
  EXPECT_TRUE(depths_corrected_twice(*together).empty());
  EXPECT_EQ(together->depths.back().patches.count(), 0);
}

}  // namespace
}  // namespace burnish
