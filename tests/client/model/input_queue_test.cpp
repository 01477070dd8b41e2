#include "client/model/input/input_queue.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using Eigen::Vector2d;
using Kind = InputEvent::Kind;

InputEvent moved(double x) {
  return {.kind = Kind::kMove, .place = {x, 0}};
}
InputEvent button(int code, bool down) {
  return {.kind = Kind::kButton, .code = code, .down = down};
}
InputEvent typed_key(int code, bool down) {
  return {.kind = Kind::kKey, .code = code, .down = down};
}
InputEvent typed_character(int code) {
  return {.kind = Kind::kCharacter, .code = code};
}

std::vector<size_t> sizes_of_steps(InputQueue& queue) {
  std::vector<size_t> sizes;
  while (queue.has_more()) sizes.push_back(queue.next().size());
  return sizes;
}

TEST(InputQueue, ADragBetweenTwoPicturesIsSeenFromItsBeginningToItsEnd) {
  InputQueue queue;
  for (int x = 1; x <= 5; ++x) queue.add(moved(x));
  queue.add(button(0, true));
  for (int x = 6; x <= 9; ++x) queue.add(moved(x));
  queue.add(button(0, false));
  queue.add(moved(20));
  struct Picture {
    double x;
    bool down;
    size_t events;
  };
  for (const Picture& picture :
       {Picture{5, false, 5}, {5, true, 1}, {9, true, 4}, {9, false, 1}, {20, false, 1}}) {
    EXPECT_TRUE(queue.has_more());
    EXPECT_EQ(queue.next().size(), picture.events);
    EXPECT_EQ(queue.pointer().place.x(), picture.x);
    EXPECT_EQ(queue.pointer().down[0], picture.down);
  }
  EXPECT_FALSE(queue.has_more());
}

TEST(InputQueue, ThePointerStaysWhereItIsWhileNothingComes) {
  InputQueue queue;
  queue.add(moved(3));
  queue.add(button(2, true));
  queue.next();
  queue.next();
  EXPECT_TRUE(queue.next().empty());
  EXPECT_EQ(queue.pointer().place, Vector2d(3, 0));
  EXPECT_TRUE(queue.pointer().down[2]);
  EXPECT_FALSE(queue.pointer().down[0]);
}

TEST(InputQueue, BothClicksOfADoubleClickAreSeen) {
  InputQueue queue;
  for (const bool down : {true, false, true, false}) queue.add(button(0, down));
  for (const bool down : {true, false, true, false}) {
    queue.next();
    EXPECT_EQ(queue.pointer().down[0], down);
  }
}

TEST(InputQueue, APressHasThePlaceOfTheMoveBeforeIt) {
  InputQueue queue;
  queue.add(moved(7));
  queue.add(button(1, true));
  queue.add(moved(50));
  queue.next();
  EXPECT_EQ(queue.next().front().place.x(), 7);
}

TEST(InputQueue, AKeyComesAfterTheButtonThatWasReleasedBeforeIt) {
  InputQueue queue;
  queue.add(button(0, true));
  queue.add(moved(9));
  queue.add(button(0, false));
  queue.add(typed_key('Z', true));
  EXPECT_EQ(sizes_of_steps(queue), (std::vector<size_t>{1, 1, 1, 0, 0, 0, 1}));
}

TEST(InputQueue, TextAfterAClickWaitsForTheFieldThatTheClickOpens) {
  InputQueue queue;
  queue.add(button(0, true));
  queue.add(button(0, false));
  queue.add(typed_character('a'));
  queue.add(typed_character('b'));
  queue.next();
  queue.next();
  for (int picture = 0; picture < InputQueue::kPicturesUntilTyping; ++picture) {
    EXPECT_TRUE(queue.next().empty());
    EXPECT_TRUE(queue.has_more());
  }
  EXPECT_EQ(queue.next().size(), 2u);
}

TEST(InputQueue, TextLongAfterAClickComesAtOnce) {
  InputQueue queue;
  queue.add(button(0, true));
  queue.next();
  for (int picture = 0; picture < InputQueue::kPicturesUntilTyping; ++picture) queue.next();
  queue.add(typed_character('a'));
  EXPECT_EQ(queue.next().size(), 1u);
}

TEST(InputQueue, EachKeyChangesOnceInAStep) {
  InputQueue queue;
  for (const char letter : {'a', 'b', 'b'}) {
    queue.add(typed_key(letter, true));
    queue.add(typed_character(letter));
    queue.add(typed_key(letter, false));
  }
  EXPECT_EQ(sizes_of_steps(queue), (std::vector<size_t>{2, 3, 1, 2, 1}));
}

TEST(InputQueue, TheWheelTurnsWhereThePointerWas) {
  InputQueue queue;
  queue.add(moved(4));
  queue.add({.kind = Kind::kWheel, .steps = 1});
  queue.add({.kind = Kind::kWheel, .steps = 2});
  queue.add(moved(8));
  EXPECT_EQ(queue.next().size(), 1u);
  const auto wheel = queue.next();
  ASSERT_EQ(wheel.size(), 2u);
  EXPECT_EQ(wheel[1].steps, 2);
  EXPECT_EQ(wheel[1].place.x(), 4);
}

}  // namespace
}  // namespace burnish
