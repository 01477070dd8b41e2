#include "server/process/minute_limiter.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::seconds;

TEST(MinuteLimiter, AThingIsAdmittedOnceAMinuteAndTheOthersAreCounted) {
  MinuteLimiter limiter;
  const MinuteLimiter::Time begin;
  EXPECT_TRUE(limiter.take("limit", begin).is_admitted);
  EXPECT_FALSE(limiter.take("limit", begin + seconds(1)).is_admitted);
  EXPECT_TRUE(limiter.take("role", begin + seconds(1)).is_admitted);
  EXPECT_FALSE(limiter.take("limit", begin + seconds(59)).is_admitted);
  const MinuteLimiter::Turn turn = limiter.take("limit", begin + seconds(60));
  EXPECT_TRUE(turn.is_admitted);
  EXPECT_EQ(turn.left_out, 2u);
  EXPECT_FALSE(limiter.take("limit", begin + seconds(61)).is_admitted);
}

}  // namespace
}  // namespace burnish
