#include "client/live/credit_pacer.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr microseconds k60Hz{16'667};

/// A clock that the test moves.
class CreditPacing : public testing::Test {
 protected:
  void pass(double ms) { now_ += microseconds(static_cast<int64_t>(1000 * ms)); }

  /// Grants the credits that are due, and receives `frames` frames one after the other, each drawn
  /// at once.
  void run(CreditPacer& pacer, int frames, double latency_ms, double server_ms = 1) {
    for (int i = 0; i < frames; ++i) {
      pass(100);
      pacer.granted(now_ - milliseconds(static_cast<int>(latency_ms)), pacer.due(now_));
      pacer.on_frame(now_, latency_ms - server_ms, server_ms);
      pacer.on_drawn(now_);
    }
  }

  CreditPacer::Time now_{std::chrono::hours(1)};
};

TEST_F(CreditPacing, BeginsWithOneFrame) {
  const CreditPacer pacer(k60Hz);
  EXPECT_EQ(pacer.due(now_), 1);
}

TEST_F(CreditPacing, GrantsNothingWhileAFrameIsNotDrawn) {
  CreditPacer pacer(k60Hz);
  pacer.granted(now_, pacer.due(now_));
  EXPECT_EQ(pacer.due(now_), 0);
  pacer.on_frame(now_, 0, 0);
  pass(1000);
  EXPECT_EQ(pacer.due(now_), 0);
  EXPECT_EQ(pacer.next_due(), CreditPacer::Time::max());
  pacer.on_drawn(now_);
  EXPECT_EQ(pacer.due(now_), 1);
}

TEST_F(CreditPacing, LookingOftenDoesNotPutTheNextFrameOff) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 1);
  run(pacer, 10, 2);
  int granted = 0;
  for (int i = 0; i < 100; ++i) {
    pass(1);
    pacer.on_drawn(now_);
    granted += pacer.due(now_);
    pacer.granted(now_, pacer.due(now_));
  }
  EXPECT_EQ(granted, 1);
}

TEST_F(CreditPacing, AsksForTheFrameJustBeforeALongPictureIsOver) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 1);
  run(pacer, 30, 2);
  pacer.set_draw_interval(milliseconds(200));
  run(pacer, 30, 2);
  pass(150);
  EXPECT_EQ(pacer.due(now_), 0);
  pass(46);
  EXPECT_EQ(pacer.due(now_), 1);
}

TEST_F(CreditPacing, HasARoundTripOfFramesOnTheirWay) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 40);
  run(pacer, 10, 42);
  EXPECT_EQ(pacer.window(), 3);
  CreditPacer near(k60Hz), far(k60Hz);
  near.on_heartbeat(now_, 1);
  far.on_heartbeat(now_, 900);
  run(near, 10, 3);
  run(far, 20, 902);
  EXPECT_EQ(near.window(), 1);
  EXPECT_EQ(far.window(), CreditPacer::kWindowMax);
}

TEST_F(CreditPacing, IsOneFrameForASlowReader) {
  CreditPacer pacer(milliseconds(100));
  pacer.on_heartbeat(now_, 40);
  run(pacer, 10, 42);
  EXPECT_EQ(pacer.window(), 1);
}

TEST_F(CreditPacing, ShrinksWhereFramesWaitForEachOther) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 40);
  run(pacer, 10, 42);
  ASSERT_EQ(pacer.window(), 3);
  run(pacer, 10, 120);
  EXPECT_EQ(pacer.window(), 1);
  run(pacer, 5, 42);
  EXPECT_EQ(pacer.window(), 1) << "not at once";
  run(pacer, 40, 42);
  EXPECT_EQ(pacer.window(), 3);
}

TEST_F(CreditPacing, HasNoMoreOnTheirWayThanTheServerMakes) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 40);
  run(pacer, 10, 42);
  run(pacer, 20, 70, 25);
  EXPECT_EQ(pacer.window(), 2);
  run(pacer, 20, 240, 198);
  EXPECT_EQ(pacer.window(), 1);
}

TEST_F(CreditPacing, DoesNotTakeSomeLargeFramesForAFullLink) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 40);
  run(pacer, 10, 42);
  for (int i = 0; i < 5; ++i) {
    run(pacer, 4, 120);
    run(pacer, 1, 42);
  }
  EXPECT_EQ(pacer.window(), 3);
}

// A heartbeat behind a large frame measures the frame, not the link.
TEST_F(CreditPacing, TakesTheLeastRoundTrip) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 20);
  pacer.on_heartbeat(now_, 500);
  run(pacer, 10, 22);
  EXPECT_EQ(pacer.window(), 2);
}

TEST_F(CreditPacing, FollowsARoundTripThatHasGrown) {
  CreditPacer pacer(k60Hz);
  for (int second = 0; second < 5; ++second, pass(1000)) pacer.on_heartbeat(now_, 10);
  for (int second = 0; second < 30; ++second, pass(1000)) pacer.on_heartbeat(now_, 60);
  run(pacer, 10, 62);
  EXPECT_EQ(pacer.window(), 4);
}

TEST_F(CreditPacing, AsksASlowReadersFrameJustBeforeItsPicture) {
  CreditPacer pacer(milliseconds(100));
  pacer.on_heartbeat(now_, 1);
  run(pacer, 20, 20);
  EXPECT_EQ(pacer.due(now_), 0);
  EXPECT_EQ(pacer.next_due(), now_ + milliseconds(76));
  pass(75);
  EXPECT_EQ(pacer.due(now_), 0);
  pass(1);
  EXPECT_EQ(pacer.due(now_), 1);
}

TEST_F(CreditPacing, BeginsAnewWithANewStream) {
  CreditPacer pacer(k60Hz);
  pacer.on_heartbeat(now_, 40);
  run(pacer, 10, 42);
  pacer.granted(now_, 2);
  pacer.restart();
  EXPECT_EQ(pacer.window(), 1);
  EXPECT_EQ(pacer.due(now_), 1);
}

}  // namespace
}  // namespace burnish
