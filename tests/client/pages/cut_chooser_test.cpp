#include "client/pages/cut_chooser.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/generate/noise.h"
#include "tests/client/pages/page_flight.h"
#include "tests/client/pages/ready_pages.h"
#include "tests/common/pages/legal_cut.h"

namespace burnish {
namespace {

class CutChooserOn : public testing::Test {
 protected:
  CutQuestion question(const Camera& camera, const PageBudget& budget = {}) const {
    CutQuestion asked;
    asked.view = make_page_view(camera, kFlightPicture, scan_.directory.head.grid);
    asked.targets = full_targets(false);
    asked.budget = budget;
    return asked;
  }
  const ChosenCut& choose(const CutQuestion& asked) {
    return chooser_.choose(asked, ready_.find());
  }

  const SyntheticScan scan_ = make_synthetic_scan();
  const KnownPages known_ = know_all(scan_);
  ReadyPages ready_{scan_};
  CutChooser chooser_{known_};
};

TEST_F(CutChooserOn, AnyPagesReadyMakeALegalCutWithoutAHole) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    for (PageId page = 0; page < scan_.directory.head.root(); ++page)
      ready_.set(page, uniform(seed, page) < 0.8);
    const ChosenCut& cut = choose(question(camera_over(uniform(seed, 1), 0.5, 1.5)));
    ASSERT_TRUE(is_legal_cut(scan_.directory, cut.set));
    ASSERT_NEAR(scan_.drawn_area(cut.set), 1, 1e-9);
  }
}

TEST_F(CutChooserOn, WithoutTheRootNothingIsShown) {
  ready_.set(scan_.directory.head.root(), false);
  EXPECT_TRUE(choose(question(camera_over(0.5, 0.5, 1))).pages.empty());
}

TEST_F(CutChooserOn, WhatIsUsedAndReadyIsShown) {
  const ChosenCut& cut = choose(question(camera_over(0.5, 0.5, 1)));
  EXPECT_EQ(cut.pages.size(), cut.used.size());
  for (const WantedPage& wanted : cut.used) {
    EXPECT_EQ(cut.set[wanted.page], 1);
    EXPECT_TRUE(chooser_.is_used(wanted.page));
  }
}

TEST_F(CutChooserOn, EveryPageOfTheCutThatIsInViewIsDrawn) {
  for (const double distance : {500.0, 3.0, 0.1, 0.01}) {
    const CutQuestion asked = question(camera_over(0.3, 0.6, distance));
    const ChosenCut& cut = choose(asked);
    for (const PageId page : cut.pages) {
      const bool is_in_view = is_visible(asked.view, scan_.directory.entries[page].bounds, 0);
      const bool is_drawn = std::ranges::find(cut.visible_pages, page) != cut.visible_pages.end();
      ASSERT_TRUE(is_drawn || !is_in_view) << page << " at " << distance;
    }
  }
}

TEST_F(CutChooserOn, AMissingPageTakesTheFinerOnesWithIt) {
  const PageId missing = scan_.directory.head.level_begin(4);
  ready_.set(missing, false);
  const ChosenCut& cut = choose(question(camera_over(0.5, 0.5, 1)));
  for (const PageId page : cut.pages)
    for (const PageId coarser : scan_.directory.coarser[page]) EXPECT_NE(coarser, missing);
  EXPECT_NEAR(scan_.drawn_area(cut.set), 1, 1e-9);
}

TEST_F(CutChooserOn, TheTriangleBudgetHoldsInTheFirstPicture) {
  for (const uint64_t triangles : {100u, 1'000u, 5'000u, 20'000u}) {
    CutChooser chooser(known_);
    const auto asked = question(camera_over(0.5, 0.5, 0.7), {.triangles = triangles});
    const ChosenCut& cut = chooser.choose(asked, ready_.find());
    EXPECT_LE(cut.triangles, triangles);
    EXPECT_LE(scan_.drawn_triangles(cut.set), triangles);
    EXPECT_GT(cut.coarseness, 0);
    EXPECT_EQ(cut.limit, CutLimit::kTriangles);
  }
}

TEST_F(CutChooserOn, ABudgetIsUsedToFourFifthsAtLeast) {
  const auto asked = question(camera_over(0.5, 0.5, 0.7), {.triangles = 20'000});
  EXPECT_GT(scan_.drawn_triangles(choose(asked).set), 16'000u);
}

TEST_F(CutChooserOn, TheTrianglesOfAnAllVisibleCutAreExact) {
  const ChosenCut& cut = choose(question(camera_over(0.5, 0.5, 4)));
  EXPECT_EQ(cut.visible_pages, cut.pages);
  EXPECT_EQ(cut.triangles, scan_.drawn_triangles(cut.set));
}

TEST_F(CutChooserOn, TheValuesOfAFrameAreABudgetToo) {
  const ChosenCut& cut = choose(question(camera_over(0.5, 0.5, 1), {.vertices = 3'000}));
  uint64_t vertices = 0;
  for (const PageId page : cut.pages) vertices += scan_.directory.entries[page].vertices;
  EXPECT_LE(vertices, 3'000u);
  EXPECT_EQ(cut.limit, CutLimit::kVertices);
}

TEST_F(CutChooserOn, ABudgetBelowTheRootLeavesTheRoot) {
  const ChosenCut& cut = choose(question(camera_over(0.5, 0.5, 1), {.triangles = 1}));
  EXPECT_EQ(cut.pages, std::vector<PageId>{scan_.directory.head.root()});
}

// What is looked at is there in full detail whenever the budget holds it, at any zoom.
TEST_F(CutChooserOn, EverythingInViewIsLevelZeroWhereTheBudgetHoldsIt) {
  const PageBudget budget = {.triangles = 6'000};
  for (const double distance : {0.15, 0.05, 0.01, 0.001}) {
    CutQuestion asked = question(camera_over(0.43, 0.57, distance), budget);
    asked.is_at_rest = true;
    const ChosenCut& cut = choose(asked);
    EXPECT_EQ(cut.coarseness, 0);
    for (PageId page = 0; page < scan_.directory.head.level_pages[0]; ++page) {
      const bool is_in_view = is_visible(asked.view, scan_.directory.entries[page].bounds, 0);
      ASSERT_TRUE(!is_in_view || cut.set[page] == 1) << distance;
    }
  }
}

TEST_F(CutChooserOn, CoarsenessFollowsTheViewOutAndInAgain) {
  const PageBudget budget = {.triangles = 10'000};
  const CutQuestion near = question(camera_over(0.5, 0.5, 0.7), budget);
  const int coarse = choose(near).coarseness;
  CutQuestion far = question(camera_over(0.5, 0.5, 60), budget);
  for (int i = 0; i < kCoarsenessMax && choose(far).coarseness > 0; ++i) {
  }
  EXPECT_EQ(chooser_.cut().coarseness, 0);
  EXPECT_EQ(choose(near).coarseness, coarse);
}

}  // namespace
}  // namespace burnish
