#include <gmock/gmock.h>

#include "client/panels/panels.h"
#include "tests/client/panels/user.h"

namespace burnish {
namespace {

using testing::ElementsAre;

std::vector<std::string> seen_of(LightKind kind) {
  Lighting lighting{.kind = kind};
  User user;
  show_lighting(lighting, user);
  return user.seen;
}

TEST(LightPanel, EachKindHasTheStrengthsThatItKnows) {
  EXPECT_THAT(seen_of(LightKind::kClay),
              ElementsAre("clay", "Light", "Lamp", "Highlight", "Occlusion", "As at first"));
  EXPECT_THAT(seen_of(LightKind::kRadiance), ElementsAre("radiance", "Light", "Lamp", "Scaling",
                                                         "Highlight", "Occlusion", "As at first"));
  EXPECT_THAT(seen_of(LightKind::kCavity),
              ElementsAre("cavity", "Light", "Lamp", "Ridges", "Valleys", "Highlight", "Occlusion",
                          "As at first"));
  EXPECT_THAT(seen_of(LightKind::kBronze),
              ElementsAre("bronze", "Light", "Occlusion", "As at first"));
}

TEST(LightPanel, AKindIsChosen) {
  Lighting lighting;
  User user;
  user.used = "Light";
  user.option = static_cast<int>(LightKind::kRaking);
  show_lighting(lighting, user);
  EXPECT_EQ(lighting, (Lighting{.kind = LightKind::kRaking}));
}

TEST(LightPanel, AStrengthIsSetAndTheButtonSetsAllAsAtFirst) {
  Lighting lighting{.kind = LightKind::kCavity};
  User user;
  user.used = "Valleys";
  user.value = 2;
  show_lighting(lighting, user);
  EXPECT_EQ(lighting.valley, 2);
  EXPECT_EQ(lighting.ridge, 1);
  user.used = "As at first";
  show_lighting(lighting, user);
  EXPECT_EQ(lighting, Lighting());
}

}  // namespace
}  // namespace burnish
