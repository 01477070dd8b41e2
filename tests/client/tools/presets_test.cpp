#include "client/tools/presets.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "common/edit/wavelength.h"

namespace burnish {
namespace {

constexpr ScanLengths kScan{10, 0.1};

/// The same scan with noise of this deviation, in mean edges.
ScanLengths with_noise(double edges) {
  ScanLengths scan = kScan;
  scan.mean_edge = 0.06;
  EdgeFilter filter;
  filter.strength = edges < 0.02 ? 0 : 1;
  scan.noise = EdgeProposal{edges * scan.mean_edge, scan.mean_edge, false, filter};
  return scan;
}

PresetFilter full(const char* name, const ScanLengths& scan) {
  return filter_of(*find_preset(name), 1, scan);
}

double wave_of(const PresetFilter& filter) {
  return wavelength_of_alpha(kScan.length_unit, filter.curve.alpha(0));
}

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
  EXPECT_EQ(filter_of(preset, 0.5, kScan).curve, filter_of(preset, 1, kScan).curve);
  const Preset& bands = *find_preset("Bring out an inscription");
  EXPECT_EQ(filter_of(bands, 0, kScan).equaliser.gain(2), 1);
  EXPECT_DOUBLE_EQ(filter_of(bands, 0.5, kScan).equaliser.gain(2), 1.75);
  EXPECT_DOUBLE_EQ(filter_of(bands, 1, kScan).equaliser.gain(2), 2.5);
  EXPECT_TRUE(check_strength(1).is_ok());
  EXPECT_FALSE(check_strength(1.01).is_ok());
}

TEST(Presets, NoiseThatWasNotMeasuredIsThatOfFourCells) {
  const PresetFilter filter = full("Reduce scanner noise", kScan);
  EXPECT_NEAR(wave_of(filter), 4 * kScan.cell_size, 1e-12);
  EXPECT_EQ(filter.beta, 0);
}

TEST(Presets, AScanWithoutNoiseKeepsItsFineRelief) {
  const ScanLengths clean = with_noise(0.02);
  EXPECT_EQ(full("Reduce scanner noise", clean).beta, 1);
  EXPECT_EQ(full("Bring out an inscription", clean).equaliser.gain(1), 1);
  EXPECT_EQ(full("Deepen carving", clean).equaliser.gain(1), 1);
  EXPECT_EQ(effect_of(*find_preset("Reduce scanner noise"), clean),
            "The scan has no noise to speak of: nothing changes");
}

TEST(Presets, MoreNoiseIsSmoothedMoreAndByLongerWaves) {
  double beta = 1, wave = 0;
  for (const double noise : {0.04, 0.06, 0.1, 0.2}) {
    const PresetFilter filter = full("Reduce scanner noise", with_noise(noise));
    EXPECT_TRUE(filter.beta < beta || filter.beta == 0) << noise;
    EXPECT_GE(wave_of(filter), std::max(wave, kWaveCellsMin * kScan.cell_size) - 1e-12) << noise;
    beta = filter.beta;
    wave = wave_of(filter);
  }
  EXPECT_EQ(beta, 0);
  EXPECT_LE(wave, 4 * kScan.cell_size);
}

TEST(Presets, NoMoreReliefThanNoiseIsTaken) {
  ScanLengths rough = with_noise(0.1);
  rough.sharp_bend = 10;  // waves of 0.23 take 0.0013 of it
  EXPECT_EQ(full("Reduce scanner noise", rough).beta, 0);
  rough.sharp_bend = 100;
  const double relief = std::pow(wave_of(full("Reduce scanner noise", rough)) / 6.283185, 2) * 10;
  EXPECT_NEAR(full("Reduce scanner noise", rough).beta, 1 - rough.noise->noise / relief, 1e-6);
}

TEST(Presets, APresetThatFindsNoNoiseIsInForceWhereItsValuesAre) {
  const ScanLengths clean = with_noise(0.01);
  const Preset& preset = *find_preset("Reduce scanner noise");
  EXPECT_EQ(strength_of(preset, filter_of(preset, 0.5, clean), clean), 1);
  EXPECT_FALSE(strength_of(preset, {1, TransferCurve(50), {}}, clean));
}

TEST(Presets, WhatBendsSharplyIsNeitherMeltedNorSwollen) {
  ScanLengths slim = kScan;
  slim.sharp_bend = 30;  // ears of a radius of a third
  const double radius = slim.length_unit / slim.sharp_bend;
  for (const Preset& preset : presets()) {
    if (preset.beta == 1 || preset.noise_cells > 0) continue;
    const TransferCurve curve = filter_of(preset, 1, slim).curve;
    double low = curve.points()[0].alpha;
    for (const auto& point : curve.points()) low = std::min(low, point.alpha);
    const double wave = wavelength_of_alpha(slim.length_unit, low);
    EXPECT_LE(wave, 1.5 * radius + 1e-9) << preset.name;
    EXPECT_GE(wave, kWaveCellsMin * slim.cell_size - 1e-9) << preset.name;
    EXPECT_EQ(curve.is_constant(), preset.curve.is_constant()) << preset.name;
  }
}

TEST(Presets, ACoarseGridGetsLessOfThem) {
  ScanLengths coarse = kScan;
  coarse.sharp_bend = 60;  // a radius of 1.7 cells
  const PresetFilter sharp = full("Sharpen all", coarse), smooth = full("Keep creases", coarse);
  EXPECT_NEAR(wave_of(sharp), kWaveCellsMin * kScan.cell_size, 1e-9);
  EXPECT_NEAR(sharp.beta, 3, 1e-9) << "1.2 radii are two cells";
  coarse.sharp_bend = 120;
  EXPECT_NEAR(full("Sharpen all", coarse).beta, 1.5, 1e-9);
  EXPECT_NEAR(full("Keep creases", coarse).beta, 0.75, 1e-9);
  EXPECT_NEAR(smooth.beta, 0, 1e-9);
}

TEST(Presets, SharpeningKeepsEdgesAsTheNoiseAsks) {
  const ScanLengths noisy = with_noise(0.2);
  const PresetFilter sharp = full("Sharpen all", noisy);
  EXPECT_EQ(sharp.beta, 3);
  EXPECT_EQ(sharp.edges, noisy.noise->filter);
  EXPECT_TRUE(changes_edges(sharp, {}));
  EXPECT_FALSE(changes_edges(sharp, find_edge_preset("relief")->filter)) << "the user's stay";
  EXPECT_FALSE(full("Sharpen all", with_noise(0.01)).edges);
  EXPECT_FALSE(filter_of(*find_preset("Sharpen all"), 0, noisy).edges);
  EXPECT_FALSE(full("Soften", noisy).edges);
}

TEST(Presets, SharpeningThatCannotKeepEdgesLeavesTheNoiseSmall) {
  ScanLengths kept_volume = with_noise(0.1);
  kept_volume.can_keep_edges = false;
  EXPECT_FALSE(full("Sharpen all", kept_volume).edges);
  EXPECT_NEAR(full("Sharpen all", kept_volume).beta, 1.5, 1e-9);
  kept_volume.noise->noise *= 3;
  EXPECT_EQ(full("Sharpen all", kept_volume).beta, 1);
  EXPECT_EQ(effect_of(*find_preset("Sharpen all"), kept_volume),
            "Nothing changes: the noise would grow too, while the volume is kept");
}

TEST(Presets, BandsAndTheOriginalEndKeptEdges) {
  const EdgeFilter kept = find_edge_preset("relief")->filter;
  for (const char* name : {"Bring out an inscription", "Deepen carving", "Original"})
    EXPECT_TRUE(changes_edges(full(name, kScan), kept)) << name;
  for (const char* name : {"Reduce scanner noise", "Soften", "Keep creases"})
    EXPECT_FALSE(changes_edges(full(name, kScan), kept)) << name;
}

TEST(ScanLengths, ATenthOfTheSurfaceBendsSharper) {
  std::vector<float> area(8, 0);
  area[4] = 0.7f;  // of up to a quarter of the range, in asinh
  area[0] = 0.1f;
  area[7] = 0.2f;
  EXPECT_NEAR(sharp_bend_of(10, area), std::sinh(std::asinh(10.0) * (1 - 1.0 / 12)), 1e-5);
  EXPECT_EQ(sharp_bend_of(10, {}), 0);
  EXPECT_EQ(sharp_bend_of(10, std::vector<float>(8, 0)), 0);
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
  EXPECT_EQ(effect_of(*find_preset("Reduce scanner noise"), with_noise(0.4)), "Waves under 0.4 go");
  EXPECT_EQ(effect_of(*find_preset("Reduce scanner noise"), with_noise(0.05)),
            "Waves under 0.2 shrink to 0.5");
  EXPECT_EQ(effect_of(*find_preset("Reduce scanner noise"), kScan),
            "Waves under 0.4 go; less where the scan has less noise");
  EXPECT_EQ(effect_of(*find_preset("Bring out an inscription"), with_noise(0.4)),
            "Waves under 0.6 go; those from 0.6 to 0.75 grow 2.5 times");
  EXPECT_EQ(effect_of(*find_preset("Sharpen all"), with_noise(0.2)),
            "Noise goes, edges stay; waves under 1.2 grow 3 times");
  EXPECT_EQ(effect_of(*find_preset("Keep creases"), kScan),
            "Waves under 1.2 go where the curve lets them");
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
