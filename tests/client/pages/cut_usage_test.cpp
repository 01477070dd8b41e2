#include "client/pages/cut_usage.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr PageBudget kBudget = {.triangles = 1000};

// 100 triangles more at each step, up to 2,000 at coarseness 0.
UsageByCoarseness stairs() {
  UsageByCoarseness usage;
  for (int i = 0; i < 20; ++i) usage.add(i, {.triangles = 100});
  usage.sum();
  return usage;
}

TEST(CutUsage, ThePartOfTheBudgetThatIsExceededIsNamed) {
  const PageBudget budget = {
      .triangles = 10, .vertices = 20, .resident_bytes = 30, .card_bytes = 4 * kSlotBytes};
  EXPECT_EQ(exceeded_limit({10, 20, 30, 4}, budget, 1), CutLimit::kNone);
  EXPECT_EQ(exceeded_limit({11, 20, 30, 4}, budget, 1), CutLimit::kTriangles);
  EXPECT_EQ(exceeded_limit({10, 21, 30, 4}, budget, 1), CutLimit::kVertices);
  EXPECT_EQ(exceeded_limit({10, 20, 31, 4}, budget, 1), CutLimit::kMemory);
  EXPECT_EQ(exceeded_limit({10, 20, 30, 5}, budget, 1), CutLimit::kCard);
  EXPECT_EQ(exceeded_limit({10, 0, 0, 0}, budget, 0.9), CutLimit::kTriangles);
}

TEST(CutUsage, AStepOfCoarsenessIsFivePercent) {
  EXPECT_EQ(coarseness_of(1.01f), 0);
  EXPECT_EQ(coarseness_of(1.06f), 1);
  EXPECT_EQ(coarseness_of(2), 14);
  EXPECT_EQ(coarseness_of(1e30f), kCoarsenessMax);
}

TEST(CutUsage, ACoarserCutNeverCostsMore) {
  const UsageByCoarseness usage = stairs();
  EXPECT_EQ(usage.at(0).triangles, 2000u);
  EXPECT_EQ(usage.at(13).triangles, 700u);
  EXPECT_EQ(usage.at(kCoarsenessMax + 1).triangles, 0u);
}

TEST(CutUsage, CoarsenessRisesAtOnceToNineTenthsOfTheBudget) {
  EXPECT_EQ(next_coarseness(stairs(), kBudget, 0, false), 11);
  EXPECT_EQ(next_coarseness(stairs(), kBudget, 0, true), 11);
}

TEST(CutUsage, CoarsenessFallsOneStepWhenSevenTenthsAreNotUsed) {
  EXPECT_EQ(next_coarseness(stairs(), kBudget, 15, false), 14);
  EXPECT_EQ(next_coarseness(stairs(), kBudget, 12, false), 12) << "800 triangles";
}

TEST(CutUsage, AtRestCoarsenessFallsAsFarAsFits) {
  EXPECT_EQ(next_coarseness(stairs(), kBudget, 12, true), 11);
  EXPECT_EQ(next_coarseness(stairs(), kBudget, 11, true), 11);
}

TEST(CutUsage, WithAnyBudgetTheRootAloneIsLeft) {
  UsageByCoarseness usage;
  usage.add(kCoarsenessMax, {.triangles = 5});
  usage.add(kCoarsenessMax + 1, {.triangles = 5});
  usage.sum();
  EXPECT_EQ(next_coarseness(usage, {.triangles = 1}, 0, false), kCoarsenessMax + 1);
}

}  // namespace
}  // namespace burnish
