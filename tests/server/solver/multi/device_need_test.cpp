#include "server/solver/multi/device_need.h"

#include <gtest/gtest.h>

#include "server/solver/cuda/cuda_filter.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

constexpr uint64_t kGigabyte = 1'000'000'000;

TEST(DeviceNeed, AScanThatFitsStaysOnOneDevice) {
  EXPECT_EQ(shards_that_fit(80 * kGigabyte, 80 * kGigabyte), 1);
  EXPECT_EQ(shards_that_fit(1, 80 * kGigabyte), 1);
}

TEST(DeviceNeed, ALargerOneTakesAsManyAsLeaveRoomForTheCut) {
  EXPECT_EQ(shards_that_fit(81 * kGigabyte, 80 * kGigabyte), 2);
  EXPECT_EQ(shards_that_fit(144 * kGigabyte, 80 * kGigabyte), 2);
  EXPECT_EQ(shards_that_fit(145 * kGigabyte, 80 * kGigabyte), 3);
}

TEST(DeviceNeed, WithoutADevicesMemoryNothingIsSplit) {
  EXPECT_EQ(shards_that_fit(kGigabyte, 0), 1);
}

// The filter of kept edges needs the same for all depths.
TEST(DeviceNeed, GrowsWithTheCornersOfTheFinestDepth) {
  const auto corners = [](const TestSystem& of) {
    return static_cast<double>(of.hierarchy->depths.back().grid.corner_count());
  };
  const TestSystem systems[] = {{reference::bumpy_sphere(3), 4},
                                {reference::bumpy_sphere(3), 5},
                                {reference::bumpy_sphere(3), 6}};
  double need[3];
  for (int i = 0; i < 3; ++i) need[i] = static_cast<double>(predict_device_bytes(systems[i]));
  EXPECT_NEAR((need[2] - need[1]) / (corners(systems[2]) - corners(systems[1])),
              (need[1] - need[0]) / (corners(systems[1]) - corners(systems[0])), 17);
  EXPECT_GT(need[0], predict_cuda_filter_bytes(systems[0].prepared->triangles.size(),
                                               systems[0].prepared->vertices.size()));
}

}  // namespace
}  // namespace burnish
