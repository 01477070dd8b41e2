#include "client/model/pointer_queue.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using Eigen::Vector2d;

TEST(PointerQueue, ADragBetweenTwoPicturesIsSeenFromItsBeginningToItsEnd) {
  PointerQueue pointer;
  for (int x = 1; x <= 5; ++x) pointer.move({x, 0});
  pointer.press(0, true);
  for (int x = 6; x <= 9; ++x) pointer.move({x, 0});
  pointer.press(0, false);
  pointer.move({20, 0});
  struct Picture {
    double x;
    bool down;
  };
  for (const Picture& step : {Picture{5, false}, {5, true}, {9, true}, {9, false}, {20, false}}) {
    EXPECT_TRUE(pointer.has_more());
    const PointerQueue::State& state = pointer.next();
    EXPECT_EQ(state.place.x(), step.x);
    EXPECT_EQ(state.down[0], step.down);
  }
  EXPECT_FALSE(pointer.has_more());
}

TEST(PointerQueue, StaysWhereItIsWhileNothingComes) {
  PointerQueue pointer;
  pointer.move({3, 4});
  pointer.press(2, true);
  pointer.next();
  pointer.next();
  EXPECT_EQ(pointer.next().place, Vector2d(3, 4));
  EXPECT_TRUE(pointer.next().down[2]);
  EXPECT_FALSE(pointer.next().down[0]);
  EXPECT_EQ(pointer.place(), Vector2d(3, 4));
}

TEST(PointerQueue, OfADoubleClickBothAreSeen) {
  PointerQueue pointer;
  for (const bool down : {true, false, true, false}) pointer.press(0, down);
  for (const bool down : {true, false, true, false}) EXPECT_EQ(pointer.next().down[0], down);
}

}  // namespace
}  // namespace burnish
