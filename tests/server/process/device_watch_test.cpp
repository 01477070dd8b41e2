#include "server/process/device_watch.h"

#include <atomic>
#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/fast_clock.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

TEST(DeviceWatch, TheFirstFailureStaysAndNothingIsAskedAfterIt) {
  int probes = 0;
  DeviceWatch watch(
      [&probes] { return ++probes == 3 ? internal_error("illegal address") : Status::ok(); },
      {milliseconds(0), milliseconds(60'000)});
  EXPECT_TRUE(watch.ask_once());
  EXPECT_TRUE(watch.ask_once());
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(watch.ask_once());
  EXPECT_EQ(probes, 3);
  EXPECT_EQ(watch.status().message(), "illegal address");
}

TEST(DeviceWatch, ItsThreadFindsAFailure) {
  const DeviceWatch watch([] { return internal_error("illegal address"); });
  while (watch.status().is_ok()) std::this_thread::yield();
  EXPECT_EQ(watch.status().message(), "illegal address");
}

TEST(DeviceWatch, AProbeThatHangsIsAFailureAfterTheLongestTimeOfAnAnswer) {
  std::promise<void> begin, end;
  FastClock clock;
  const DeviceWatch watch(
      [&, ended = end.get_future().share()] {
        begin.set_value();
        ended.wait();
        return Status::ok();
      },
      {std::chrono::hours(1), std::chrono::hours(2)}, clock.clock());
  begin.get_future().wait();
  clock.put_forward(std::chrono::hours(2));  // with the hour between two probes it is one more
  EXPECT_TRUE(watch.status().is_ok());
  clock.put_forward(std::chrono::hours(1) + milliseconds(1));
  EXPECT_THAT(watch.status().message(), testing::HasSubstr("has not answered for 7200"));
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
