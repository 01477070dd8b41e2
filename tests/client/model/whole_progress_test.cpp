#include "client/model/tasks/whole_progress.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;
using Time = WholeProgress::Time;

Time at(double seconds) {
  return Time() + milliseconds(static_cast<int64_t>(1000 * seconds));
}

const std::vector<PlannedPhase> kPlan = {{"send", 1, true}, {"cut", 4}, {"sum", 5}};

TEST(WholeProgress, PhasesAddUpToOneBar) {
  WholeProgress whole(kPlan, at(0));
  whole.report("send", 0.5, at(0.5));
  EXPECT_NEAR(whole.fraction(at(0.5)), 0.05, 1e-9);
  whole.report("cut", 0.5, at(1));
  EXPECT_NEAR(whole.fraction(at(1)), 0.3, 1e-9);
  whole.report("sum", 1, at(5));
  EXPECT_NEAR(whole.fraction(at(5)), 1, 1e-9);
}

TEST(WholeProgress, NeverGoesBack) {
  WholeProgress whole(kPlan, at(0));
  whole.report("sum", 0.2, at(1));
  const double before = whole.fraction(at(1));
  whole.report("cut", 0, at(1));
  whole.report("unknown", 0, at(1));
  EXPECT_GE(whole.fraction(at(1)), before);
}

TEST(WholeProgress, APhaseWithoutReportsGoesOnWithTheTimeButDoesNotEnd) {
  WholeProgress whole(kPlan, at(0));
  whole.report("sum", 0, at(1));
  const double early = whole.fraction(at(2)), late = whole.fraction(at(4));
  EXPECT_LT(early, late);
  EXPECT_LT(whole.fraction(at(1000)), 0.96);
}

TEST(WholeProgress, TheTimeLeftIsLongerOnASlowMachine) {
  WholeProgress quick(kPlan, at(0)), slow(kPlan, at(0));
  quick.report("cut", 0, at(1));
  slow.report("cut", 0, at(1));
  quick.report("sum", 0, at(5));
  slow.report("sum", 0, at(41));
  EXPECT_NEAR(quick.seconds_left(at(5)).value(), 5, 0.5);
  EXPECT_GT(slow.seconds_left(at(41)).value(), 30);
}

TEST(WholeProgress, ASlowLinkSaysNothingAboutThePhasesAfterIt) {
  WholeProgress whole(kPlan, at(0));
  whole.report("send", 0.5, at(30));
  EXPECT_NEAR(whole.seconds_left(at(30)).value(), 30 + 9, 1e-9);
}

TEST(WholeProgress, AtFirstThereIsNoTimeLeft) {
  WholeProgress whole(kPlan, at(0));
  EXPECT_FALSE(whole.seconds_left(at(0.5)).has_value());
}

TEST(WholeProgress, TimesAreRounded) {
  EXPECT_EQ(time_left_text(3), "a few seconds left");
  EXPECT_EQ(time_left_text(21), "about 20 s left");
  EXPECT_EQ(time_left_text(59), "about 1 min left");
  EXPECT_EQ(time_left_text(200), "about 3 min left");
}

}  // namespace
}  // namespace burnish
