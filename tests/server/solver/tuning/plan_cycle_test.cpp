#include "server/solver/tuning/plan_cycle.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/solver/cycle/vcycle.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

std::vector<int> depths_corrected_twice(const Multigrid& on) {
  std::vector<int> depths;
  for (int depth = on.hierarchy->coarsest; depth <= on.hierarchy->finest; ++depth)
    if (is_corrected_twice(on, depth)) depths.push_back(depth);
  return depths;
}

TEST(PlannedCycle, LeavesAScanWithoutNearSheetsAsItIs) {
  const TestSystem system(reference::bumpy_sphere(4), 6);
  EXPECT_TRUE(depths_corrected_twice(system).empty());
  EXPECT_EQ(system.plan->patches.count(), 0);
}

TEST(PlannedCycle, CorrectsTwoDepthsTwiceWhereSheetsComeTogether) {
  const TestSystem system(reference::spiked_sphere(), 6);
  EXPECT_EQ(depths_corrected_twice(system), (std::vector{4, 5}));
}

TEST(PlannedCycle, NeverCorrectsTheCoarsestDepth) {
  const TestSystem system(reference::spiked_sphere(), 5);
  EXPECT_EQ(system.hierarchy->coarsest, 3);
  EXPECT_EQ(depths_corrected_twice(system), std::vector{4});
}

TEST(PlannedCycle, PutsPatchesWhereATrialIsSlow) {
  const TestSystem system(reference::spiked_sphere(), 6);
  EXPECT_GT(system.plan->patches.count(), 50);
}

TEST(PlannedCycle, LeavesSheetsThatAreKeptTogetherAsTheyAre) {
  const TestSystem system(reference::spiked_sphere(), 6);
  const Multigrid together{system.prepared, make_hierarchy(*system.prepared, Sheets::kTogether)};
  const auto plan = plan_cycle(together.prepared, together.hierarchy).value();
  EXPECT_EQ(plan->first_weak_depth, CyclePlan().first_weak_depth);
  EXPECT_EQ(plan->patches.count(), 0);
}

TEST(PlannedCycle, KnowsScansWithFlatPieces) {
  const auto has_flat_parts = [](const char* kind) {
    const TestSystem system(generate_scan({.kind = kind, .vertices = 5000}).value(), 6);
    return system.plan->has_flat_parts;
  };
  for (const char* kind : {"part", "sheet"}) EXPECT_TRUE(has_flat_parts(kind)) << kind;
  for (const char* kind : {"tablet", "blob", "icosphere"})
    EXPECT_FALSE(has_flat_parts(kind)) << kind;
}

}  // namespace
}  // namespace burnish
