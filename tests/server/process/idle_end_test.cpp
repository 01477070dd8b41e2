#include "server/process/idle_end.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::hours;
using std::chrono::seconds;

TEST(IdleEnd, ComesSoLongAfterTheLastUse) {
  const IdleEnd::Time start;
  IdleEnd end(seconds(60), start);
  EXPECT_FALSE(end.is_over(false, start + seconds(59)));
  EXPECT_FALSE(end.is_over(true, start + seconds(60)));
  EXPECT_FALSE(end.is_over(false, start + seconds(119)));
  EXPECT_TRUE(end.is_over(false, start + seconds(120)));
}

TEST(IdleEnd, DoesNotComeWhileSomebodyIsThere) {
  const IdleEnd::Time start;
  IdleEnd end(seconds(1), start);
  EXPECT_FALSE(end.is_over(true, start + hours(5)));
}

TEST(IdleEnd, NeverComesUnlessItIsAskedFor) {
  const IdleEnd::Time start;
  IdleEnd end(seconds(0), start);
  EXPECT_FALSE(end.is_over(false, start + hours(1000)));
}

}  // namespace
}  // namespace burnish
