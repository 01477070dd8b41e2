#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "common/generate/noise.h"
#include "tests/client/pages/page_flight.h"

namespace burnish {
namespace {

const SyntheticScan& faulty_scan() {
  static const SyntheticScan made = make_synthetic_scan();
  return made;
}

Camera random_camera(uint64_t seed, uint64_t index) {
  return camera_over(uniform(seed, 3 * index), uniform(seed, 3 * index + 1),
                     0.02 * std::pow(100.0, uniform(seed, 3 * index + 2)));
}

void fly_about(PageFlight& flight, uint64_t seed, int legs, int pictures) {
  for (int leg = 0; leg < legs && !testing::Test::HasFatalFailure(); ++leg)
    flight.fly(random_camera(seed, leg), random_camera(seed, leg + 1), pictures);
}

PageFlightOptions faulty(uint64_t seed, const LinkFaults& faults) {
  PageFlightOptions options;
  options.link.seed = seed;
  options.link.faults = faults;
  return options;
}

PageFlightOptions slow_link() {
  PageFlightOptions options;
  options.link.speed.bytes_per_second = 3e5;
  return options;
}

constexpr LinkFaults kAllFaults = {.lost = 0.02,
                                   .failed = 0.05,
                                   .damaged = 0.05,
                                   .cut_short = 0.03,
                                   .doubled = 0.1,
                                   .late = 0.2,
                                   .wrong_size = 0.03};

TEST(PageLoaderFaults, EveryPictureIsWholeWhateverTheLinkDoes) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    PageFlight flight(faulty_scan(), faulty(seed, kAllFaults));
    fly_about(flight, seed, 12, 40);
  }
}

TEST(PageLoaderFaults, AFaultyLinkLeadsToTheSameCutAsAGoodOne) {
  const Camera camera = camera_over(0.5, 0.5, 1);
  PageFlight good(faulty_scan(), {});
  good.settle(camera);
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    PageFlight flight(
        faulty_scan(),
        faulty(seed, {.lost = 0.01, .failed = 0.03, .damaged = 0.03, .doubled = 0.2, .late = 0.2}));
    flight.settle(camera);
    EXPECT_EQ(flight.given_up(), 0u);
    EXPECT_EQ(flight.cut().set, good.cut().set) << seed;
  }
}

TEST(PageLoaderFaults, BudgetsHoldWhileAFaultyLinkIsFlownOver) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    PageFlightOptions options = faulty(seed, kAllFaults);
    options.budget = {.triangles = 4'000, .resident_bytes = 700'000, .card_bytes = 90 * kSlotBytes};
    PageFlight flight(faulty_scan(), options);
    fly_about(flight, seed, 12, 40);
  }
}

TEST(PageLoaderFaults, AServerThatSendsRubbishIsAskedAFewTimesAndNamed) {
  PageFlight flight(faulty_scan(), slow_link());
  const Camera camera = camera_over(0.5, 0.5, 1);
  while (flight.cut().pages.empty()) flight.picture(camera);
  flight.link().set_faults({.damaged = 1});
  flight.settle(camera);
  const CutStatus status = flight.loader().status();
  EXPECT_EQ(status.reason, CutReason::kFailed);
  EXPECT_EQ(flight.given_up(), status.failed_items);
  flight.link().set_faults({});
  flight.loader().on_link_made();
  flight.settle(camera);
  EXPECT_TRUE(flight.loader().status().is_full_detail);
}

TEST(PageLoaderFaults, ABrokenLinkIsMadeGoodByTheNext) {
  PageFlight flight(faulty_scan(), slow_link());
  const Camera camera = camera_over(0.5, 0.5, 1);
  for (int i = 0; i < 20; ++i) flight.picture(camera);
  flight.link().set_broken(true);
  for (int i = 0; i < 600; ++i) flight.picture(camera);
  flight.link().set_broken(false);
  flight.link().forget();
  flight.loader().on_link_lost();
  flight.loader().on_link_made();
  flight.settle(camera);
  EXPECT_TRUE(flight.loader().status().is_full_detail);
}

/// The most that a flight has held at one time.
struct Peak {
  size_t pages = 0;
  uint64_t slots = 0;
  size_t in_flight = 0;
};

Peak peak_of(PageFlight& flight, uint64_t seed, int legs) {
  Peak peak;
  for (int leg = 0; leg < legs && !testing::Test::HasFatalFailure(); ++leg) {
    flight.fly(random_camera(seed, leg), random_camera(seed, leg + 1), 20);
    peak.pages = std::max(peak.pages, flight.loader().cache().page_count());
    peak.slots = std::max(peak.slots, flight.loader().cache().slots().begun());
    peak.in_flight = std::max(peak.in_flight, flight.loader().in_flight().count_in_flight());
  }
  return peak;
}

TEST(PageLoaderFaults, NothingGrowsOnALongFlight) {
  PageFlightOptions options = faulty(5, kAllFaults);
  options.budget = {.triangles = 4'000, .resident_bytes = 500'000, .card_bytes = 90 * kSlotBytes};
  PageFlight flight(faulty_scan(), options);
  peak_of(flight, 4, 20);
  const Peak first = peak_of(flight, 5, 60), second = peak_of(flight, 6, 60);
  EXPECT_LE(second.pages, first.pages + first.pages / 20);
  EXPECT_LE(second.slots, 90u);
  EXPECT_LE(second.in_flight, 2 * first.in_flight);
  EXPECT_LE(flight.loader().in_flight().failures().count(),
            faulty_scan().directory.entries.size() + faulty_scan().directory.head.block_count());
}

}  // namespace
}  // namespace burnish
