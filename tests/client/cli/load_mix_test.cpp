#include "client/cli/bench/load_mix.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(LoadMix, NamesTheWeights) {
  EXPECT_EQ(parse_load_mix("draw=1,drag=0.5,paint=2")->weight, (std::array{1.0, 0.5, 2.0}));
  EXPECT_EQ(parse_load_mix("paint=3")->weight, (std::array{0.0, 0.0, 3.0}));
}

TEST(LoadMix, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(parse_load_mix("sing=1").status().message(), HasSubstr("'sing=1'"));
  EXPECT_THAT(parse_load_mix("draw").status().message(), HasSubstr("'draw'"));
  EXPECT_THAT(parse_load_mix("draw=-1").status().message(), HasSubstr("'draw=-1'"));
  EXPECT_THAT(parse_load_mix("draw=1x").status().message(), HasSubstr("'draw=1x'"));
  EXPECT_THAT(parse_load_mix("draw=0,paint=0").status().message(), HasSubstr("weights of 0"));
  EXPECT_FALSE(parse_load_mix("").is_ok());
}

TEST(LoadMix, ChoosesByWeight) {
  std::mt19937 random(1);
  const LoadMix mix{{0, 1, 3}};
  int drags = 0;
  for (int i = 0; i < 4000; ++i) {
    const Activity activity = mix.choose(random);
    EXPECT_NE(activity, Activity::kDraw);
    drags += activity == Activity::kDrag ? 1 : 0;
  }
  EXPECT_NEAR(drags, 1000, 150);
}

}  // namespace
}  // namespace burnish
