#include "client/tools/presets.h"

#include <set>

#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "common/edit/wavelength.h"

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

TEST(Presets, StrengthGoesFromNothingToTheWholeFilter) {
  const Preset& preset = *find_preset("Bring out an inscription");
  EXPECT_EQ(filter_of(preset, 0, 10, 0.1).beta, 1);
  EXPECT_DOUBLE_EQ(filter_of(preset, 0.5, 10, 0.1).beta, 2);
  EXPECT_DOUBLE_EQ(filter_of(preset, 1, 10, 0.1).beta, 3);
  EXPECT_EQ(filter_of(preset, 0.5, 10, 0.1).curve, preset.curve);
  EXPECT_TRUE(check_strength(1).is_ok());
  EXPECT_FALSE(check_strength(1.01).is_ok());
}

TEST(Presets, NoiseIsAsFineAsTheGrid) {
  const Preset& preset = *find_preset("Reduce scanner noise");
  const double length_unit = 10, cell_size = 0.1;
  const double alpha = filter_of(preset, 1, length_unit, cell_size).curve.alpha(0);
  EXPECT_NEAR(wavelength_of_alpha(length_unit, alpha), *preset.wave_cells * cell_size, 1e-12);
  EXPECT_LE(alpha, alpha_of_grid_limit(length_unit, cell_size));
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
