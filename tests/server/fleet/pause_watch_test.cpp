#include "server/fleet/pause_watch.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::seconds;

TEST(PauseWatch, SaysOnceThatNobodyHasAskedForTooLong) {
  PauseWatch::Nanoseconds now{};
  PauseWatch watch(seconds(8), [&] { return now; });
  now += seconds(8);
  EXPECT_FALSE(watch.was_paused());
  now += seconds(9);
  EXPECT_TRUE(watch.was_paused());
  EXPECT_FALSE(watch.was_paused());
}

TEST(PauseWatch, TimeGoesOn) {
  const auto before = PauseWatch::since_boot();
  EXPECT_GT(before.count(), 0);
  EXPECT_GE(PauseWatch::since_boot(), before);
}

}  // namespace
}  // namespace burnish
