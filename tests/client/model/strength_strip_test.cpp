#include "client/model/workspace/strength_strip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(StrengthStrip, AStrengthStandsBetweenAWeakerAndAStrongerOne) {
  EXPECT_THAT(strengths_beside(0.5), ElementsAre(0.25, 0.5, 0.75));
  EXPECT_THAT(strengths_beside(0.8), ElementsAre(0.4, 0.8, 1));
}

TEST(StrengthStrip, TheFullStrengthHasTwoWeakerOnes) {
  EXPECT_THAT(strengths_beside(1),
              ElementsAre(DoubleNear(1.0 / 3, 1e-12), DoubleNear(2.0 / 3, 1e-12), 1));
}

TEST(StrengthStrip, AClosedOneWaitsForNothing) {
  const StrengthStrip strip;
  EXPECT_FALSE(strip.is_open());
  EXPECT_EQ(strip.trial_text(), "");
}

}  // namespace
}  // namespace burnish
