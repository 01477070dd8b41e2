#include "client/pages/link_meter.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;

/// Calls over a simulated link of 1 MB/s: parts of 10,000 bytes come every 10 ms.
class MeteredLink : public testing::Test {
 protected:
  static constexpr size_t kPartBytes = 10'000;

  void begin(milliseconds round_trip) {
    meter_.on_first_part(now_, now_ + round_trip);
    now_ += round_trip;
  }
  void receive(int parts) {
    for (int i = 0; i < parts; ++i) {
      now_ += milliseconds(10);
      meter_.on_part(kPartBytes, now_);
    }
  }

  LinkMeter meter_;
  LinkMeter::Time now_{std::chrono::hours(1)};
};

TEST_F(MeteredLink, IsUnknownAtFirst) {
  EXPECT_EQ(meter_.speed().bytes_per_second, 0);
  EXPECT_EQ(meter_.speed().round_trip_seconds, 0);
}

TEST_F(MeteredLink, HasItsSpeedFromTheFirstPartOn) {
  begin(milliseconds(40));
  receive(20);
  meter_.on_end();
  EXPECT_NEAR(meter_.speed().bytes_per_second, 1e6, 1);
  EXPECT_NEAR(meter_.speed().round_trip_seconds, 0.04, 1e-9);
}

TEST_F(MeteredLink, LeavesOutTimesWithoutACall) {
  for (int call = 0; call < 5; ++call) {
    begin(milliseconds(40));
    receive(10);
    meter_.on_end();
    now_ += std::chrono::seconds(10);
  }
  EXPECT_NEAR(meter_.speed().bytes_per_second, 1e6, 1);
}

TEST_F(MeteredLink, IsSharedByCallsAtTheSameTime) {
  begin(milliseconds(40));
  receive(5);
  meter_.on_first_part(now_ - milliseconds(60), now_);
  receive(20);
  meter_.on_end();
  receive(10);
  meter_.on_end();
  EXPECT_NEAR(meter_.speed().bytes_per_second, 1e6, 1);
}

TEST_F(MeteredLink, TakesTheLeastOfTheLastRoundTrips) {
  for (const int ms : {30, 200, 50}) {
    begin(milliseconds(ms));
    meter_.on_end();
  }
  EXPECT_NEAR(meter_.speed().round_trip_seconds, 0.03, 1e-9);
  for (int i = 0; i < 8; ++i) {
    begin(milliseconds(90));
    meter_.on_end();
  }
  EXPECT_NEAR(meter_.speed().round_trip_seconds, 0.09, 1e-9);
}

}  // namespace
}  // namespace burnish
