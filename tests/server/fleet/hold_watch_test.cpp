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

TEST(HoldWatch, BearsTheDatabasesAbsenceForAsLongAsItIsTold) {
  Watched one({seconds(10), seconds(3), seconds(60)});
  one.lease_left = seconds(-50);
  EXPECT_TRUE(one.watch.check().is_ok());
  one.lease_left = milliseconds(-50'001);
  EXPECT_FALSE(one.watch.check().is_ok());
  Watched shorter({seconds(10), seconds(3), seconds(5)});
  shorter.lease_left = seconds(2);
  EXPECT_TRUE(shorter.watch.check().is_ok());
  shorter.lease_left = milliseconds(1999);
  EXPECT_FALSE(shorter.watch.check().is_ok());
}

TEST(HoldWatch, EndsAtTheLastQuarterOfAShortLease) {
  Watched one({seconds(1), milliseconds(200)});
  one.lease_left = milliseconds(251);
  EXPECT_TRUE(one.watch.check().is_ok());
  one.lease_left = milliseconds(249);
  EXPECT_FALSE(one.watch.check().is_ok());
}

TEST(HoldWatch, SaysOnceThatTheProcessStoodStill) {
  Watched one({seconds(10), seconds(3)});
  one.now += seconds(9);
  EXPECT_THAT(one.watch.check().message(), HasSubstr("stood still"));
  EXPECT_TRUE(one.watch.check().is_ok());
}

}  // namespace
}  // namespace burnish
