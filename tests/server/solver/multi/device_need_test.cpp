#include "server/solver/multi/device_need.h"

#include <gtest/gtest.h>

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

TEST(DeviceNeed, GrowsWithTheCornersOfTheFinestDepth) {
  const TestSystem coarse(reference::bumpy_sphere(3), 4), fine(reference::bumpy_sphere(3), 5);
  EXPECT_NEAR(double(predict_device_bytes(fine)) / double(predict_device_bytes(coarse)),
              double(fine.hierarchy->depths.back().grid.corner_count()) /
                  coarse.hierarchy->depths.back().grid.corner_count(),
              0.01);
}

}  // namespace
}  // namespace burnish
