// How presets become edits on a scan, and edits presets.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/tools/presets.h"
#include "common/base/fixed_text.h"
#include "common/edit/wavelength.h"

namespace burnish {

static double size_of(const PresetBand& band, const ScanLengths& scan) {
  const double wave = band.alpha > 0 ? wavelength_of_alpha(scan.length_unit, band.alpha) : 0;
  return std::max(wave, band.cells * scan.cell_size);
}

static double part_of(double strength, double value) {
  return 1 + strength * (value - 1);
}

static TransferCurve curve_of(const Preset& preset, const ScanLengths& scan) {
  if (!preset.wave_cells) return preset.curve;
  const double wavelength = std::max(*preset.wave_cells, kWaveCellsMin) * scan.cell_size;
  return TransferCurve(alpha_of_wavelength(scan.length_unit, wavelength));
}

PresetFilter filter_of(const Preset& preset, double strength, const ScanLengths& scan) {
  PresetFilter filter{part_of(strength, preset.beta), curve_of(preset, scan), {}};
  for (const PresetBand& band : preset.bands)
    filter.equaliser.bands.push_back({size_of(band, scan), part_of(strength, band.gain)});
  return filter;
}

// Values may have been through a file or a slider, which round them.
static bool is_near(double a, double b) {
  constexpr double kRounding = 1e-5;
  return std::abs(a - b) <= kRounding * std::max({1.0, std::abs(a), std::abs(b)});
}

static bool is_near(const TransferCurve& a, const TransferCurve& b) {
  if (a.is_constant() && b.is_constant()) return is_near(a.alpha(0), b.alpha(0));
  return std::ranges::equal(a.points(), b.points(), [](const auto& one, const auto& other) {
    return is_near(one.alpha, other.alpha) && is_near(one.kappa, other.kappa);
  });
}

static bool is_near(const Equaliser& a, const Equaliser& b) {
  return std::ranges::equal(a.bands, b.bands, [](const Band& one, const Band& other) {
    return is_near(one.size / other.size, 1) && is_near(one.gain, other.gain);
  });
}

static double strength_of_value(double value, double full) {
  return (value - 1) / (full - 1);
}

std::optional<double> strength_of(const Preset& preset, const PresetFilter& values,
                                  const ScanLengths& scan) {
  double strength = 0;
  if (preset.beta != 1) {
    strength = strength_of_value(values.beta, preset.beta);
  } else if (values.equaliser.bands.size() == preset.bands.size()) {
    for (size_t b = 0; b < preset.bands.size() && strength == 0; ++b)
      if (preset.bands[b].gain != 1)
        strength = strength_of_value(values.equaliser.bands[b].gain, preset.bands[b].gain);
  }
  if (!(strength > 0 && strength <= 1 + 1e-6)) return std::nullopt;
  const PresetFilter filter = filter_of(preset, strength, scan);
  const bool is_it = is_near(filter.beta, values.beta) && is_near(filter.curve, values.curve) &&
                     is_near(filter.equaliser, values.equaliser);
  return is_it ? std::optional(is_near(strength, 1) ? 1 : strength) : std::nullopt;
}

std::string_view strength_word(double strength) {
  if (strength <= 0) return "none";
  if (strength < 0.4) return "a little";
  if (strength < 0.65) return "half";
  return strength < 0.95 ? "most" : "all";
}

static std::string length_text(double length) {
  constexpr int kDigits = 3;
  return fixed_text(length, kDigits);
}

static std::string change_text(double gain) {
  if (gain == 1) return "stay";
  if (gain == 0) return "go";
  return (gain > 1 ? "grow " : "shrink to ") + length_text(gain) + (gain > 1 ? " times" : "");
}

static std::string effect_of_bands(const Preset& preset, const ScanLengths& scan) {
  std::string text;
  double from = 0;
  for (const PresetBand& band : preset.bands) {
    const double to = size_of(band, scan);
    text += text.empty() ? "Waves " : "; those ";
    text += from > 0 ? "from " + length_text(from) + " to " : "under ";
    text += length_text(to) + " " + change_text(band.gain);
    from = to;
  }
  return text;
}

std::string effect_of(const Preset& preset, const ScanLengths& scan) {
  if (!preset.bands.empty()) return effect_of_bands(preset, scan);
  if (preset.beta == 1) return "Nothing changes";
  const TransferCurve curve = curve_of(preset, scan);
  const auto least =
      std::ranges::min_element(curve.points(), {}, [](const auto& point) { return point.alpha; });
  const std::string length = length_text(wavelength_of_alpha(scan.length_unit, least->alpha));
  return "Waves under " + length + " " + change_text(preset.beta) +
         (curve.is_constant() ? "" : " where the curve lets them");
}

Preset own_preset(const std::string& name, const PresetFilter& values, const ScanLengths& scan) {
  Preset preset{
      .name = name, .description = "Your own", .beta = values.beta, .curve = values.curve};
  for (const Band& band : values.equaliser.bands)
    preset.bands.push_back(
        {.alpha = 2 * std::numbers::pi * scan.length_unit / band.size, .gain = band.gain});
  return preset;
}

}  // namespace burnish
