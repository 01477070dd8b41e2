#include "client/raster/part_times.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(PartTimes, AddUpWhereNothingInterrupts) {
  PartTimes times;
  for (int i = 0; i < 90; ++i) times.add(0.001);
  for (int i = 0; i < 100; ++i) times.add(0.0001);
  EXPECT_NEAR(times.seconds(), 0.1, 1e-9);
}

TEST(PartTimes, InterruptedPartsCountAsTheMeanOfTheOthers) {
  PartTimes times;
  for (int i = 0; i < 1000; ++i) times.add(i % 20 == 0 ? 0.012 : 0.0001);
  EXPECT_NEAR(times.seconds(), 0.1, 1e-9);
}

TEST(PartTimes, ASlowProcessorCountsInFull) {
  PartTimes times;
  for (int i = 0; i < 100; ++i) times.add(i % 4 == 0 ? 0.001 : 0.01);
  EXPECT_NEAR(times.seconds(), 0.775, 1e-9);
}

TEST(PartTimes, NoPartTakesNoTime) {
  EXPECT_EQ(PartTimes().seconds(), 0);
}

}  // namespace
}  // namespace burnish
