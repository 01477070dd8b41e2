#include "common/pages/page_walk.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/pages/made_pages.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Status follow(const WalkCode& code, size_t vertices, size_t patches) {
  return follow_walk(code, vertices, patches).status();
}

TEST(PageWalk, AStripIsAStartAndThenNewVertices) {
  const PlannedWalk planned = plan_walk(two_triangles());
  // The sides of the first triangle come in the order 01, 12, 20; the second one lies at 12.
  EXPECT_THAT(planned.code.steps, ElementsAre(8, 3, 0));
  EXPECT_THAT(planned.sources, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(planned.code.turns, ElementsAre(0, 0));
}

TEST(PageWalk, AClosedFanNeedsNoVertexByName) {
  Page page{.patches = {{kNoPage, 6}},
            .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}},
            .positions = std::vector<Vec3i>(7, Vec3i::Zero())};
  const PlannedWalk planned = plan_walk(page);
  EXPECT_TRUE(planned.code.named_vertices.empty());
  EXPECT_TRUE(follow(planned.code, 7, 1).is_ok());
}

TEST(PageWalk, ATriangleOfAnotherPatchThanItsNeighbourNamesIt) {
  Page page = two_triangles();
  page.id = 9;
  page.patches = {{1, 1}, {2, 1}};
  const PlannedWalk planned = plan_walk(page);
  EXPECT_THAT(planned.code.turns, ElementsAre(0, 1));
  EXPECT_THAT(planned.code.named_patches, ElementsAre(1));
}

TEST(PageWalk, AStepThatCannotBeTakenIsNamed) {
  const auto code = [](std::vector<uint8_t> steps) {
    return WalkCode{.steps = std::move(steps), .turns = {0, 0}};
  };
  for (const uint8_t first : {0, 1, 2, 3, 4, 5, 7, 9})
    EXPECT_THAT(follow(code({first}), 4, 1).message(), HasSubstr("step 0 of the walk")) << first;
  for (const uint8_t second : {4, 5, 8, 15})
    EXPECT_THAT(follow(code({8, second}), 4, 1).message(), HasSubstr("step 1 of the walk"));
  EXPECT_THAT(follow(code({8, 0, 0}), 9, 1).message(), HasSubstr("step 2 of the walk"));
}

TEST(PageWalk, WhatIsLeftOverIsNamed) {
  const WalkCode good = plan_walk(two_triangles()).code;
  EXPECT_TRUE(follow(good, 4, 1).is_ok());
  EXPECT_THAT(follow(good, 5, 1).message(), HasSubstr("4 of 5 vertices"));
  WalkCode code = good;
  code.turns.push_back(0);
  EXPECT_THAT(follow(code, 4, 1).message(), HasSubstr("2 of 3 triangles"));
  code = good;
  code.named_vertices = {0};
  EXPECT_THAT(follow(code, 4, 1).message(), HasSubstr("0 of 1 named vertices"));
  code = good;
  code.named_patches = {0};
  EXPECT_THAT(follow(code, 4, 1).message(), HasSubstr("0 of 1 named patches"));
}

TEST(PageWalk, APatchBeyondTheEndCannotBeNamed) {
  WalkCode code = plan_walk(two_triangles()).code;
  code.turns[1] = 1;
  code.named_patches = {1};
  EXPECT_TRUE(follow(code, 4, 2).is_ok());
  EXPECT_FALSE(follow(code, 4, 1).is_ok());
}

TEST(PageWalk, RandomCodesNeverLeadOutside) {
  std::mt19937 random(7);
  int taken = 0;
  for (int run = 0; run < 20'000; ++run) {
    WalkCode code;
    const size_t triangles = 1 + random() % 12;
    code.turns.assign(triangles, 0);
    code.steps.push_back(8);
    for (size_t i = 0; i < 2 * triangles; ++i)
      code.steps.push_back(static_cast<uint8_t>(random() % 20 == 0 ? random() % 16 : random() % 5));
    for (int i = 0; i < 4; ++i) code.named_vertices.push_back(random() % 4);
    const auto walk = follow_walk(code, 14, 1);
    if (walk.is_ok()) ++taken;
  }
  // Most codes end with the wrong counts; what matters is that the sanitizers see them all.
  EXPECT_LT(taken, 20'000);
}

TEST(PageWalk, ChangedCodesOfSheetsAreFollowedOrRefused) {
  std::mt19937 random(8);
  const Page page = made_sheet({.columns = 12, .rows = 12}, 4);
  const WalkCode good = plan_walk(page).code;
  int taken = 0;
  for (int run = 0; run < 5'000; ++run) {
    WalkCode code = good;
    code.steps[random() % code.steps.size()] = static_cast<uint8_t>(random() % 5);
    const auto walk = follow_walk(code, page.positions.size(), page.patches.size());
    if (!walk.is_ok()) continue;
    ++taken;
    for (const PageTriangle& triangle : walk->triangles)
      for (const uint16_t vertex : triangle) EXPECT_LT(vertex, page.positions.size());
  }
  EXPECT_GT(taken, 0);
}

}  // namespace
}  // namespace burnish
