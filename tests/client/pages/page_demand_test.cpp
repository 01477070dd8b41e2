#include "client/pages/page_demand.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "tests/client/pages/ready_pages.h"
#include "tests/common/pages/legal_cut.h"

namespace burnish {
namespace {

const SyntheticScan& demanded_scan() {
  static const SyntheticScan made = make_synthetic_scan();
  return made;
}

PageView view_of(const Camera& camera) {
  return make_page_view(camera, kFlightPicture, demanded_scan().directory.head.grid);
}

PageDemand demand_of(const KnownPages& known, const Camera& camera,
                     const CutTargets& targets = full_targets(false),
                     const PageSet& was_used = {}) {
  DemandFinder finder(known);
  PageSet used = was_used;
  used.resize(known.head().page_count());
  return finder.find(view_of(camera), {}, targets, used);
}

PageSet set_of(const PageDemand& demand) {
  PageSet set(demanded_scan().directory.entries.size());
  for (const WantedPage& wanted : demand.pages) set[wanted.page] = 1;
  return set;
}

TEST(PageDemand, IsALegalCutFromEverywhere) {
  const KnownPages known = know_all(demanded_scan());
  for (const double distance : {10.0, 2.0, 0.5, 0.05, 0.001})
    for (const double x : {-0.5, 0.0, 0.4})
      EXPECT_TRUE(is_legal_cut(demanded_scan().directory,
                               set_of(demand_of(known, camera_over(x, 0.3, distance)))));
}

// The definition, without blocks, order or bookkeeping.
PageSet wanted_by_definition(const PageView& view, const CutTargets& targets) {
  PageSet set(demanded_scan().directory.entries.size());
  for (PageId page = 0; page < set.size(); ++page) {
    const PageBounds& bounds = demanded_scan().directory.entries[page].bounds;
    const double distance =
        std::max<double>((bounds.centre - view.eye).norm() - bounds.radius, view.nearest);
    const double error = bounds.error * view.pixels_at_one / distance / targets.error_px;
    const double edge = bounds.edge * view.pixels_at_one / distance / targets.edge_px;
    const double weight = is_visible(view, bounds, 0) ? 1 : kUnseenWeight;
    set[page] = weight * std::max(error, edge) > targets.take ? 1 : 0;
  }
  set.back() = 1;
  close_cut(demanded_scan().directory, set);
  return set;
}

TEST(PageDemand, IsTheClosureOfWhatIsTooCoarse) {
  const KnownPages known = know_all(demanded_scan());
  for (const double distance : {5.0, 1.0, 0.2, 0.01}) {
    const Camera camera = camera_over(0.6, 0.4, distance);
    const CutTargets targets = full_targets(false);
    EXPECT_EQ(set_of(demand_of(known, camera, targets)),
              wanted_by_definition(view_of(camera), targets))
        << distance;
  }
}

TEST(PageDemand, HasTheRootAlwaysAndLast) {
  const KnownPages known = know_all(demanded_scan());
  Camera away = camera_over(0.5, 0.5, 3);
  away.target.x() += 1000;
  const PageDemand demand = demand_of(known, away);
  ASSERT_FALSE(demand.pages.empty());
  EXPECT_EQ(demand.pages.back().page, demanded_scan().directory.head.root());
}

TEST(PageDemand, ACoarserPageIsNeverLessUrgent) {
  const KnownPages known = know_all(demanded_scan());
  std::map<PageId, WantedPage> by_page;
  for (const WantedPage& wanted : demand_of(known, camera_over(0.2, 0.7, 0.1)).pages)
    by_page[wanted.page] = wanted;
  for (const auto& [page, wanted] : by_page)
    for (const PageId coarser : demanded_scan().directory.coarser[page]) {
      ASSERT_GE(by_page.at(coarser).excess, wanted.excess);
      ASSERT_GE(by_page.at(coarser).is_seen, wanted.is_seen);
    }
}

TEST(PageDemand, WhatIsOutOfViewCountsAHundredth) {
  const KnownPages known = know_all(demanded_scan());
  const Camera camera = camera_over(0.5, 0.5, 0.02);
  const PageView view = view_of(camera);
  const CutTargets targets = full_targets(false);
  size_t beside = 0;
  for (const WantedPage& wanted : demand_of(known, camera, targets).pages) {
    const PageBounds& bounds = wanted.entry->bounds;
    if (is_visible(view, bounds, 0) || wanted.page == known.head().root()) continue;
    ASSERT_GT(wanted.excess, 1);
    if (!wanted.is_seen) ++beside;
  }
  EXPECT_GT(beside, 5u) << "the surroundings are there when the camera turns";
}

size_t count_dropped(const PageSet& before, const PageDemand& after) {
  const PageSet kept = set_of(after);
  size_t dropped = 0;
  for (PageId page = 0; page < before.size(); ++page)
    if (before[page] != 0 && kept[page] == 0) ++dropped;
  return dropped;
}

TEST(PageDemand, AUsedPageStaysAWhileWhenTheCameraMoves) {
  const KnownPages known = know_all(demanded_scan());
  const CutTargets targets = {.error_px = 1, .edge_px = 6, .take = 1, .keep = 0.9f};
  const PageSet before = set_of(demand_of(known, camera_over(0.5, 0.5, 3), targets));
  double farther = 3;
  while (farther < 10 &&
         count_dropped(before, demand_of(known, camera_over(0.5, 0.5, farther), targets)) == 0)
    farther *= 1.01;
  const Camera there = camera_over(0.5, 0.5, farther),
               beyond = camera_over(0.5, 0.5, 1.3 * farther);
  EXPECT_EQ(count_dropped(before, demand_of(known, there, targets, before)), 0u);
  EXPECT_GT(count_dropped(before, demand_of(known, beyond, targets, before)), 0u);
}

TEST(PageDemand, WithoutKeepingTheLastCutIsOfNoInfluence) {
  const KnownPages known = know_all(demanded_scan());
  const Camera camera = camera_over(0.5, 0.5, 4);
  const PageSet all(demanded_scan().directory.entries.size(), 1);
  EXPECT_EQ(set_of(demand_of(known, camera, full_targets(false), all)),
            set_of(demand_of(known, camera, full_targets(false))));
}

TEST(PageDemand, SharpeningWantsMoreOfTheError) {
  const KnownPages known = know_all(demanded_scan());
  const PageSet nothing(known.head().page_count());
  const CutTargets targets = {.error_px = 1, .edge_px = 1000};
  const PageView view = view_of(camera_over(0.5, 0.5, 1));
  DemandFinder finder(known);
  const size_t plain = finder.find(view, {.gain = 1}, targets, nothing).pages.size();
  EXPECT_GT(finder.find(view, {.gain = 8}, targets, nothing).pages.size(), 2 * plain);
}

TEST(PageDemand, AnUnknownDirectoryIsWantedFromCoarseToFine) {
  const KnownPages known(demanded_scan().directory.head);
  const PageDemand demand = demand_of(known, camera_over(0.5, 0.5, 0.5));
  ASSERT_FALSE(demand.blocks.empty());
  EXPECT_TRUE(demand.pages.empty());
  int level = demanded_scan().directory.head.level_count();
  for (const WantedBlock& wanted : demand.blocks) {
    const int next = known.head().level_of(known.pages_of(wanted.block).begin);
    EXPECT_LE(next, level);
    level = next;
  }
  EXPECT_EQ(demand.blocks.front().block, known.block_count() - 1) << "the root's";
}

TEST(PageDemand, ABlockThatIsTooFineIsNotWanted) {
  const KnownPages known(demanded_scan().directory.head);
  for (const WantedBlock& wanted : demand_of(known, camera_over(0.5, 0.5, 30)).blocks)
    EXPECT_GE(wanted.block, known.level_zero_blocks());
}

TEST(PageDemand, AFinePageMakesItsCoarserPagesBlocksWanted) {
  KnownPages known(demanded_scan().directory.head);
  known.add(0, demanded_scan().block(0));
  const PageId page = 10;
  const Eigen::Vector2d at = demanded_scan().places[page].center();
  const PageDemand demand = demand_of(known, camera_over(at.x(), at.y(), 0.01));
  for (const PageId coarser : demanded_scan().directory.coarser[page])
    EXPECT_TRUE(std::ranges::any_of(demand.blocks, [&](const WantedBlock& wanted) {
      return wanted.block == known.block_of(coarser);
    }));
}

}  // namespace
}  // namespace burnish
