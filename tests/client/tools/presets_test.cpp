#include "client/tools/presets.h"

#include <set>

#include <gtest/gtest.h>

#include "common/base/limits.h"

namespace burnish {
namespace {

TEST(Presets, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_EQ(find_preset(preset.name), &preset);
  }
  EXPECT_EQ(find_preset("no such filter"), nullptr);
}

TEST(Presets, AllAreWithinTheLimitsAndBelowTheContrastThatIsWarnedOf) {
  for (const Preset& preset : presets()) {
    EXPECT_TRUE(check_beta(preset.beta).is_ok()) << preset.name;
    EXPECT_LE(preset.curve.contrast(), kCurveContrastWarn) << preset.name;
  }
}

TEST(Presets, Figure3HoldsWhatItsNameSays) {
  const TransferCurve& grooves = find_preset("Keep grooves")->curve;
  const TransferCurve& ridges = find_preset("Keep ridges")->curve;
  const TransferCurve& creases = find_preset("Keep creases")->curve;
  EXPECT_GT(grooves.alpha(-100), 10 * grooves.alpha(100));
  EXPECT_GT(ridges.alpha(100), 10 * ridges.alpha(-100));
  EXPECT_GT(creases.alpha(100), 10 * creases.alpha(0));
  EXPECT_GT(creases.alpha(-100), 10 * creases.alpha(0));
}

}  // namespace
}  // namespace burnish
