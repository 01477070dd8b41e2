#include "client/tools/pen_pressure.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(PenPressure, IsThePartOfItsRange) {
  EXPECT_DOUBLE_EQ(pressure_of({.min = 0, .max = 65536, .value = 16384}), 0.25);
  EXPECT_DOUBLE_EQ(pressure_of({.min = -100, .max = 300, .value = 0}), 0.25);
}

TEST(PenPressure, OutsideItsRangeIsTheNearestEnd) {
  EXPECT_EQ(pressure_of({.min = 0, .max = 1023, .value = 2000}), 1);
  EXPECT_EQ(pressure_of({.min = 0, .max = 1023, .value = -1}), 0);
}

TEST(PenPressure, ARangeWithoutALengthPressesNothing) {
  EXPECT_EQ(pressure_of({.min = 5, .max = 5, .value = 5}), 0);
}

TEST(PenPressure, ScalesTheStrengthAndLeavesAValidStroke) {
  EXPECT_DOUBLE_EQ(strength_under(0.6, 0.5), 0.3);
  EXPECT_DOUBLE_EQ(strength_under(0.6, 1), 0.6);
  EXPECT_GT(strength_under(0.6, 0), 0);
}

TEST(PenGesture, APenThatDoesNotTouchLeavesTheGestureToTheMouse) {
  const PressureAxis hovering{.min = 0, .max = 100, .value = 0};
  const PressureAxis pressed{.min = 0, .max = 100, .value = 40};
  PenGesture gesture;
  EXPECT_FALSE(gesture.begin({{hovering}}).has_value());
  EXPECT_FALSE(gesture.go_on({{pressed}}).has_value());
}

TEST(PenGesture, TheStrongestPenCounts) {
  PenGesture gesture;
  const PressureAxis tip{.min = 0, .max = 100, .value = 40};
  const PressureAxis eraser{.min = 0, .max = 100, .value = 0};
  EXPECT_DOUBLE_EQ(gesture.begin({{tip, eraser}}).value(), 0.4);
}

TEST(PenGesture, APenThatLiftsPressesNothingUntilTheGestureEnds) {
  PenGesture gesture;
  gesture.begin({{PressureAxis{.min = 0, .max = 100, .value = 40}}});
  EXPECT_EQ(gesture.go_on({{PressureAxis{.min = 0, .max = 100, .value = 0}}}), 0);
  gesture.end();
  EXPECT_FALSE(gesture.go_on({{PressureAxis{.min = 0, .max = 100, .value = 40}}}).has_value());
}

}  // namespace
}  // namespace burnish
