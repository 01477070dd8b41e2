#include "client/tools/presets.h"

#include <set>

#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "common/edit/wavelength.h"

namespace burnish {
namespace {

constexpr ScanLengths kScan{10, 0.1};

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
  const Preset& preset = *find_preset("Sharpen all");
  EXPECT_EQ(filter_of(preset, 0, kScan).beta, 1);
  EXPECT_DOUBLE_EQ(filter_of(preset, 0.5, kScan).beta, 2);
  EXPECT_DOUBLE_EQ(filter_of(preset, 1, kScan).beta, 3);
  EXPECT_EQ(filter_of(preset, 0.5, kScan).curve, preset.curve);
  const Preset& bands = *find_preset("Bring out an inscription");
  EXPECT_EQ(filter_of(bands, 0, kScan).equaliser.gain(2), 1);
  EXPECT_DOUBLE_EQ(filter_of(bands, 0.5, kScan).equaliser.gain(2), 1.75);
  EXPECT_DOUBLE_EQ(filter_of(bands, 1, kScan).equaliser.gain(2), 2.5);
  EXPECT_TRUE(check_strength(1).is_ok());
  EXPECT_FALSE(check_strength(1.01).is_ok());
}

TEST(Presets, NoiseIsAsFineAsTheGrid) {
  const Preset& preset = *find_preset("Reduce scanner noise");
  const double alpha = filter_of(preset, 1, kScan).curve.alpha(0);
  EXPECT_NEAR(wavelength_of_alpha(kScan.length_unit, alpha), *preset.wave_cells * kScan.cell_size,
              1e-12);
  EXPECT_LE(alpha, alpha_of_grid_limit(kScan.length_unit, kScan.cell_size));
}

TEST(Presets, BandsOfEachAreValidOnFineAndCoarseGrids) {
  for (const Preset& preset : presets())
    for (const double cell_size : {1e-4, 0.01, 0.1, 1.0}) {
      const Status checked = check_equaliser(filter_of(preset, 1, {10, cell_size}).equaliser);
      EXPECT_TRUE(checked.is_ok()) << preset.name << ": " << checked.to_string();
    }
}

TEST(Presets, StrengthIsFoundInTheValuesAndInNoOthers) {
  for (const Preset& preset : presets()) {
    if (preset.name == "Original") continue;
    for (const double strength : {0.3, 1.0}) {
      const PresetFilter values = filter_of(preset, strength, kScan);
      const auto found = strength_of(preset, values, kScan);
      ASSERT_TRUE(found) << preset.name;
      EXPECT_NEAR(*found, strength, 1e-9) << preset.name;
    }
    PresetFilter other = filter_of(preset, 1, kScan);
    other.curve = TransferCurve(77);
    EXPECT_FALSE(strength_of(preset, other, kScan)) << preset.name;
    EXPECT_FALSE(strength_of(preset, {1, TransferCurve(50), {}}, kScan)) << preset.name;
  }
}

TEST(Presets, EffectIsSaidInTheScansUnits) {
  EXPECT_EQ(effect_of(*find_preset("Reduce scanner noise"), kScan), "Waves under 0.4 go");
  EXPECT_EQ(effect_of(*find_preset("Bring out an inscription"), {100, 0.1}),
            "Waves under 0.6 go; those from 0.6 to 6.28 grow 2.5 times");
  EXPECT_EQ(strength_word(0.2), "a little");
  EXPECT_EQ(strength_word(0.5), "half");
  EXPECT_EQ(strength_word(1), "all");
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
