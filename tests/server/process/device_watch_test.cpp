#include "server/process/device_watch.h"

#include <atomic>
#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;

/// Waits until the watch reports a failure.
Status failure_of(const DeviceWatch& watch) {
  for (int i = 0; i < 6000 && watch.status().is_ok(); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  return watch.status();
}

TEST(DeviceWatch, TheFirstFailureStays) {
  std::atomic<int> probes{0};
  const DeviceWatch watch(
      [&probes] { return ++probes == 3 ? internal_error("illegal address") : Status::ok(); },
      {milliseconds(1), milliseconds(60'000)});
  EXPECT_EQ(failure_of(watch).message(), "illegal address");
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(probes, 3);
  EXPECT_FALSE(watch.status().is_ok());
}

TEST(DeviceWatch, AProbeThatHangsIsAFailure) {
  std::promise<void> end;
  const auto ended = end.get_future().share();
  const DeviceWatch watch(
      [ended] {
        ended.wait();
        return Status::ok();
      },
      {milliseconds(1), milliseconds(20)});
  EXPECT_THAT(failure_of(watch).message(), testing::HasSubstr("has not answered for"));
  end.set_value();
}

TEST(DeviceWatch, AWorkingDeviceIsAskedAgainAndAgain) {
  std::promise<void> third;
  std::atomic<int> probes{0};
  const DeviceWatch watch(
      [&] {
        if (++probes == 3) third.set_value();
        return Status::ok();
      },
      {milliseconds(1), milliseconds(60'000)});
  third.get_future().wait();
  EXPECT_TRUE(watch.status().is_ok());
}

}  // namespace
}  // namespace burnish
