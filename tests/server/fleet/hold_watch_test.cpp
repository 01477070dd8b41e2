#include "server/fleet/hold_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::HasSubstr;

struct Watched {
  explicit Watched(const LeaseTimes& times)
      : watch(
            times, [this] { return lease_left; }, [this] { return now; }) {}

  std::chrono::duration<double> lease_left{10};
  PauseWatch::Nanoseconds now{};
  HoldWatch watch;
};

TEST(HoldWatch, EndsTwoSecondsBeforeTheLeaseUntilAHeartbeatSucceeds) {
  Watched one({seconds(10), seconds(3)});
  one.lease_left = seconds(2);
  EXPECT_TRUE(one.watch.check().is_ok());
  one.lease_left = milliseconds(1999);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(one.watch.check().code(), StatusCode::kUnavailable);
    EXPECT_THAT(one.watch.check().message(), HasSubstr("does not reach the database"));
  }
  one.lease_left = seconds(10);
  EXPECT_TRUE(one.watch.check().is_ok());
}

// Expects that the watch bears the lease with so much left, and nothing less.
void expect_borne_until(milliseconds left, const LeaseTimes& times) {
  Watched one(times);
  one.lease_left = left;
  EXPECT_TRUE(one.watch.check().is_ok()) << left.count();
  one.lease_left = left - milliseconds(1);
  EXPECT_FALSE(one.watch.check().is_ok()) << left.count();
}

TEST(HoldWatch, BearsTheDatabasesAbsenceForAsLongAsItIsTold) {
  expect_borne_until(seconds(-50), {seconds(10), seconds(3), seconds(60)});
  expect_borne_until(seconds(2), {seconds(10), seconds(3), seconds(5)});
}

TEST(HoldWatch, EndsAtTheLastQuarterOfAShortLease) {
  expect_borne_until(milliseconds(250), {seconds(1), milliseconds(200)});
}

TEST(HoldWatch, SaysOnceThatTheProcessStoodStill) {
  Watched one({seconds(10), seconds(3)});
  one.now += seconds(9);
  EXPECT_THAT(one.watch.check().message(), HasSubstr("stood still"));
  EXPECT_TRUE(one.watch.check().is_ok());
}

}  // namespace
}  // namespace burnish
