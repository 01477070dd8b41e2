#include "client/pages/page_loader.h"

#include <gtest/gtest.h>

#include "tests/client/pages/page_flight.h"

namespace burnish {
namespace {

const SyntheticScan& loaded_scan() {
  static const SyntheticScan made = make_synthetic_scan();
  return made;
}

const Camera kWhole = camera_over(0.5, 0.5, 3);
const Camera kNear = camera_over(0.3, 0.4, 0.1);
const Camera kBeside = camera_over(0.8, 0.7, 0.1);

PageFlightOptions options_with(const PageBudget& budget) {
  PageFlightOptions options;
  options.budget = budget;
  return options;
}

// About 30 % of the whole view's pages.
PageFlightOptions small_card() {
  return options_with({.card_bytes = 700 * kSlotBytes});
}

PageSet fresh_cut(const Camera& camera, const PageFlightOptions& options) {
  PageFlight flight(loaded_scan(), options);
  flight.settle(camera);
  return flight.cut().set;
}

TEST(PageLoader, ALinkThatDeliversLeadsToFullDetail) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kWhole);
  EXPECT_TRUE(flight.loader().status().is_full_detail);
  EXPECT_EQ(flight.cut().pages.size(), flight.cut().used.size());
  EXPECT_EQ(flight.loader().status().bytes_left, 0u);
}

TEST(PageLoader, APictureThatRestsEarlyStaysAsFineAsAMovingOne) {
  PageFlight flight(loaded_scan(), {});
  flight.rests_early = true;
  flight.settle(kWhole);
  const uint64_t early = flight.cut().triangles;
  EXPECT_TRUE(flight.loader().is_settled());
  EXPECT_TRUE(flight.loader().is_prompt());
  flight.rests_early = false;
  flight.settle(kWhole);
  EXPECT_GT(flight.cut().triangles, early);
}

TEST(PageLoader, TheFirstPictureComesAfterTwoRoundTrips) {
  PageFlight flight(loaded_scan(), {});
  const auto begin = flight.now();
  while (flight.cut().pages.empty() && flight.now() < begin + std::chrono::seconds(1))
    flight.picture(kWhole);
  EXPECT_LT(flight.now() - begin, std::chrono::milliseconds(200));
}

TEST(PageLoader, ZoomingInAndOutEndsWhereAFreshClientEnds) {
  for (const PageFlightOptions& options : {PageFlightOptions(), small_card()}) {
    PageFlight flight(loaded_scan(), options);
    flight.settle(kWhole);
    flight.fly(kWhole, kNear, 60);
    flight.settle(kNear);
    EXPECT_EQ(flight.cut().set, fresh_cut(kNear, options));
    flight.fly(kNear, kWhole, 60);
    flight.settle(kWhole);
    EXPECT_EQ(flight.cut().set, fresh_cut(kWhole, options));
  }
}

TEST(PageLoader, PanningEndsWhereAFreshClientEnds) {
  for (const PageFlightOptions& options : {PageFlightOptions(), small_card()}) {
    PageFlight flight(loaded_scan(), options);
    flight.settle(kNear);
    flight.fly(kNear, kBeside, 40);
    flight.settle(kBeside);
    EXPECT_EQ(flight.cut().set, fresh_cut(kBeside, options));
  }
}

TEST(PageLoader, UnderATriangleBudgetPathsEndAlikeToo) {
  const PageFlightOptions options = options_with({.triangles = 12'000});
  PageFlight flight(loaded_scan(), options);
  flight.settle(kWhole);
  flight.fly(kWhole, kNear, 30);
  flight.fly(kNear, kWhole, 30);
  flight.settle(kWhole);
  EXPECT_EQ(flight.cut().set, fresh_cut(kWhole, options));
}

TEST(PageLoader, ASlowCardMovesCoarselyAndRestsInFullDetail) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kWhole);
  const PageSet full = flight.cut().set;
  flight.moving_triangles_max = 12'000;
  flight.fly(kWhole, kNear, 10);
  EXPECT_LE(flight.cut().triangles, 12'000u);
  flight.fly(kNear, kWhole, 10);
  flight.picture(kWhole);
  EXPECT_LE(flight.cut().triangles, 12'000u) << "a moment is no rest";
  flight.settle(kWhole);
  EXPECT_EQ(flight.cut().set, full);
}

TEST(PageLoader, ASlowCardBecomesFullyDetailedInOnePicture) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kWhole);
  const size_t full = flight.cut().pages.size();
  flight.moving_triangles_max = 12'000;
  flight.fly(kNear, kWhole, 60);
  std::vector<size_t> sizes;
  for (int i = 0; i < 60; ++i) {
    flight.picture(kWhole);
    if (sizes.empty() || sizes.back() != flight.cut().pages.size())
      sizes.push_back(flight.cut().pages.size());
  }
  ASSERT_GE(sizes.size(), 2u);
  EXPECT_EQ(sizes.back(), full);
  EXPECT_LE(sizes.size(), 4u);
}

TEST(PageLoader, EachBudgetIsNamedWhenItStopsTheCut) {
  const std::vector<std::pair<PageBudget, CutReason>> cases = {
      {{.triangles = 5'000}, CutReason::kTriangles},
      {{.resident_bytes = 1'000'000}, CutReason::kMemory},
      {{.card_bytes = 100 * kSlotBytes}, CutReason::kCard}};
  for (const auto& [budget, reason] : cases) {
    PageFlight flight(loaded_scan(), options_with(budget));
    flight.settle(kWhole);
    const CutStatus status = flight.loader().status();
    EXPECT_EQ(status.reason, reason) << status_text(status);
    EXPECT_FALSE(status.is_full_detail);
    EXPECT_LT(status.drawn_part(), 1);
  }
}

TEST(PageLoader, LoadingIsSaidWithTheBytesThatAreLeft) {
  PageFlightOptions slow;
  slow.link.speed.bytes_per_second = 3e5;
  PageFlight flight(loaded_scan(), slow);
  for (int i = 0; i < 20; ++i) flight.picture(kWhole);
  const CutStatus status = flight.loader().status();
  EXPECT_EQ(status.reason, CutReason::kLoading);
  EXPECT_GT(status.bytes_left, 10'000u);
}

TEST(PageLoader, DetailStaysWhileTheCameraMoves) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kWhole);
  const uint64_t triangles = flight.cut().triangles;
  flight.picture(camera_over(0.501, 0.5, 3));
  EXPECT_FALSE(flight.loader().status().is_full_detail);
  EXPECT_GE(flight.cut().triangles, triangles * 9 / 10);
}

TEST(PageLoader, AMovingCameraWantsNoFullDetailThatIsNotThere) {
  PageFlight flight(loaded_scan(), {});
  Camera camera = kNear;
  const auto move_once = [&] {
    camera.azimuth_degrees += 0.001;
    flight.picture(camera);
  };
  do move_once();
  while (flight.loader().status().reason != CutReason::kMoving);
  const size_t prompt = flight.cut().used.size();
  for (int i = 0; i < 3; ++i) flight.picture(camera);
  EXPECT_GT(flight.cut().used.size(), 1.5 * prompt);
  move_once();
  EXPECT_LT(flight.cut().used.size(), 1.1 * prompt);
}

TEST(PageLoader, DetailStaysWhenTheCameraStops) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kWhole);
  const uint64_t triangles = flight.cut().triangles;
  const Camera beside = camera_over(0.501, 0.5, 3);
  for (int i = 0; i < 4; ++i) {
    flight.picture(beside);
    EXPECT_GE(flight.cut().triangles, triangles * 9 / 10);
  }
}

TEST(PageLoader, ADirectoryBeyondItsBudgetIsForgottenAndFetchedAgain) {
  const SyntheticScan large = make_synthetic_scan({.side = 128});
  PageFlight full(large, {}), thrifty(large, options_with({.directory_blocks = 84}));
  for (const Camera& camera : {kNear, kBeside, kNear}) {
    full.settle(camera);
    thrifty.settle(camera);
    EXPECT_EQ(thrifty.cut().set, full.cut().set);
    EXPECT_LE(thrifty.loader().known().known_blocks(), 84u);
  }
  EXPECT_GT(full.loader().known().known_blocks(), 84u);
}

TEST(PageLoader, ADirectoryThatIsTooLargeIsNamed) {
  PageFlight flight(loaded_scan(), options_with({.directory_blocks = 8}));
  flight.settle(kWhole);
  EXPECT_EQ(flight.loader().status().reason, CutReason::kMemory);
}

TEST(PageLoader, UnderABudgetTooDetailStaysWhenTheCameraBeginsToMove) {
  PageFlight flight(loaded_scan(), options_with({.triangles = 12'000}));
  flight.settle(kWhole);
  const uint64_t triangles = flight.cut().triangles;
  for (int i = 1; i <= 5; ++i) {
    flight.picture(camera_over(0.5 + 0.0002 * i, 0.5, 3));
    EXPECT_GE(flight.cut().triangles, triangles * 9 / 10);
  }
}

TEST(PageLoader, LookingBackAsksForNothing) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kWhole);
  flight.settle(kNear);
  const uint64_t asked = flight.link().bytes_asked();
  flight.settle(kWhole);
  EXPECT_EQ(flight.link().bytes_asked(), asked);
}

TEST(PageLoader, AMovingSurfaceIsShownAsFineAsItsFramesCarry) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kWhole);
  flight.surface_moves = true;
  flight.frame_vertices_max = 1'500;
  flight.picture(kWhole);
  EXPECT_LE(flight.cut().usage.vertices, 1'500u);
  EXPECT_GT(flight.cut().usage.vertices, 1'000u);
  EXPECT_EQ(flight.loader().status().reason, CutReason::kMoving);
  flight.surface_moves = false;
  flight.settle(kWhole);
  EXPECT_TRUE(flight.loader().status().is_full_detail);
}

TEST(PageLoader, APageWithoutValuesOfTheShownFrameIsNotShown) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kNear);
  const PageId fine = flight.cut().pages.back();
  flight.has_values = [fine](PageId page) { return page != fine; };
  flight.picture(kNear);
  EXPECT_EQ(flight.cut().set[fine], 0);
  EXPECT_EQ(flight.loader().status().reason, CutReason::kLoading);
  flight.has_values = nullptr;
  flight.picture(kNear);
  EXPECT_EQ(flight.cut().set[fine], 1);
}

TEST(PageLoader, AtRestShowsAsManyVerticesAsTheServerHasMemoryFor) {
  PageFlight flight(loaded_scan(), {});
  flight.settle(kNear);
  const uint64_t all = flight.cut().usage.vertices;
  flight.server_vertices_max = all / 2;
  flight.settle(kNear);
  EXPECT_LE(flight.cut().usage.vertices, all / 2);
  EXPECT_EQ(flight.loader().status().reason, CutReason::kServer);
  flight.server_vertices_max = 0;
  flight.settle(kNear);
  EXPECT_EQ(flight.cut().usage.vertices, all);
}

TEST(PageLoader, DecodingAFewPagesAPictureEndsAtTheSameCut) {
  PageFlightOptions slow;
  slow.decodes_per_picture = 3;
  EXPECT_EQ(fresh_cut(kNear, slow), fresh_cut(kNear, {}));
}

TEST(PageLoader, SlowPicturesGetAllThatAFastLinkBringsBetweenThem) {
  PageFlightOptions options;
  options.link.speed = {20e6, 0.001};
  options.picture_interval = std::chrono::milliseconds(300);
  PageFlight flight(loaded_scan(), options);
  EXPECT_LE(flight.settle(kWhole) / 0.3, 10);
}

TEST(PageLoader, SoftwareRenderingStaysWithinItsTriangles) {
  PageFlightOptions options;
  options.is_software = true;
  options.budget = software_budget();
  const SyntheticScan large = make_synthetic_scan({.side = 32, .triangles_per_page = 1000});
  PageFlight flight(large, options);
  flight.settle(camera_over(0.5, 0.5, 0.8));
  EXPECT_LE(large.drawn_triangles(flight.cut().set), 150'000u);
  EXPECT_EQ(flight.loader().status().reason, CutReason::kTriangles);
}

}  // namespace
}  // namespace burnish
