#include "server/process/line_limiter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(LineLimiter, LetsSoManyLinesOfAKindInEachSecond) {
  LineLimiter limiter(2);
  const LineLimiter::Time start = std::chrono::steady_clock::now();
  EXPECT_TRUE(limiter.admit(LineKind::kRefusedCall, start));
  EXPECT_TRUE(limiter.admit(LineKind::kRefusedCall, start + milliseconds(1)));
  EXPECT_FALSE(limiter.admit(LineKind::kRefusedCall, start + milliseconds(999)));
  EXPECT_TRUE(limiter.admit(LineKind::kEndedCall, start + milliseconds(999)));
  EXPECT_TRUE(limiter.admit(LineKind::kRefusedCall, start + milliseconds(1000)));
}

TEST(LineLimiter, SaysOnceHowManyItLeftOut) {
  LineLimiter limiter(1);
  const LineLimiter::Time start = std::chrono::steady_clock::now();
  for (int i = 0; i < 5; ++i) limiter.admit(LineKind::kRefusedCall, start);
  limiter.admit(LineKind::kConnection, start);
  EXPECT_THAT(limiter.take_left_out(start + milliseconds(500)), IsEmpty());
  EXPECT_THAT(limiter.take_left_out(start + milliseconds(1000)),
              ElementsAre("4 more lines of refused calls"));
  EXPECT_THAT(limiter.take_left_out(start + milliseconds(2000)), IsEmpty());
}

TEST(LineLimiter, AFloodThatGoesOnIsToldOfToo) {
  LineLimiter limiter(1);
  const LineLimiter::Time start = std::chrono::steady_clock::now();
  std::vector<std::string> told;
  for (int ms = 0; ms < 2100; ms += 10) {
    limiter.admit(LineKind::kRefusedCall, start + milliseconds(ms));
    for (const std::string& line : limiter.take_left_out(start + milliseconds(ms)))
      told.push_back(line);
  }
  EXPECT_THAT(told,
              ElementsAre("99 more lines of refused calls", "99 more lines of refused calls"));
}

}  // namespace
}  // namespace burnish
