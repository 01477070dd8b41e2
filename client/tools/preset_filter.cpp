// How presets become edits on a scan, and edits presets.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/tools/presets.h"
#include "common/base/fixed_text.h"
#include "common/edit/wavelength.h"

namespace burnish {

// A scan whose noise is below the first has none to speak of; one above the second is noisy. In
// mean edges.
constexpr double kNoiseMin = 0.03, kNoiseWhole = 0.07;
// Where the noise would be sharpened with the surface, it ends at so many mean edges at the most.
constexpr double kSharpenedNoiseMax = 0.15;
constexpr double kNextBand = 1.25;  // times the band of the noise; above kBandRatioMin

static double part_of(double strength, double value) {
  return 1 + strength * (value - 1);
}

/// Returns how much of what is done against noise is done, 0 to 1.
static double noisiness(const ScanLengths& scan) {
  if (!scan.noise) return 1;
  const double above = scan.noise->noise_in_edges() - kNoiseMin;
  return std::clamp(above / (kNoiseWhole - kNoiseMin), 0.0, 1.0);
}

// Independent noise is least after smoothing by a wave that grows with its root. A grid of more
// than a mean edge a cell does not hold shorter ones.
static double noise_wave(double cells_max, const ScanLengths& scan) {
  const double cells_min = std::min(kWaveCellsMin, cells_max);
  if (!scan.noise) return cells_max * scan.cell_size;
  constexpr double kEdgesPerCell = 3;
  const double edges = kEdgesPerCell * cells_max * std::sqrt(scan.noise->noise_in_edges());
  return std::clamp(edges * scan.noise->mean_edge, cells_min * scan.cell_size,
                    cells_max * scan.cell_size);
}

bool follows_noise(const Preset& preset) {
  return preset.noise_cells > 0 || preset.keeps_edges ||
         std::ranges::any_of(preset.bands, [](const PresetBand& band) { return band.cells > 0; });
}

static Equaliser bands_of(const Preset& preset, const ScanLengths& scan) {
  Equaliser equaliser;
  double noise = 0;  // waves that are
  for (const PresetBand& band : preset.bands) {
    if (band.cells > 0) {
      noise = noise_wave(band.cells, scan);
      equaliser.bands.push_back({noise, part_of(noisiness(scan), band.gain)});
    } else {
      const double wave = wavelength_of_alpha(scan.length_unit, band.alpha);
      equaliser.bands.push_back({std::max(wave, kNextBand * noise), band.gain});
    }
  }
  return equaliser;
}

static double lowest_alpha(const TransferCurve& curve) {
  return std::ranges::min_element(curve.points(), {}, &TransferCurve::Point::alpha)->alpha;
}

static bool has_limits(const WaveLimits& limits) {
  return limits.cells > 0 || limits.radii > 0 || limits.units > 0;
}

/// Returns the longest wave that a preset works on. A coarse grid may not hold it.
static double longest_wave(const Preset& preset, const ScanLengths& scan) {
  const WaveLimits& limits = preset.limits;
  double wave = wavelength_of_alpha(scan.length_unit, lowest_alpha(preset.curve));
  if (limits.cells > 0) wave = std::min(wave, limits.cells * scan.cell_size);
  if (limits.units > 0) wave = std::min(wave, limits.units * scan.length_unit);
  if (limits.radii > 0 && scan.sharp_bend > 0)
    wave = std::min(wave, limits.radii * scan.length_unit / scan.sharp_bend);
  return wave;
}

// Keeps where a curve holds well above where it lets go.
static TransferCurve raised(const TransferCurve& curve, double low) {
  constexpr double kHeldMin = 4;
  const double before = lowest_alpha(curve);
  std::vector<TransferCurve::Point> points = curve.points();
  for (TransferCurve::Point& point : points)
    point.alpha =
        point.alpha == before ? low : std::min(std::max(point.alpha, kHeldMin * low), kAlphaMax);
  return std::move(TransferCurve::create(std::move(points))).value();
}

static TransferCurve curve_of(const Preset& preset, const ScanLengths& scan) {
  if (preset.noise_cells > 0)
    return TransferCurve(
        alpha_of_wavelength(scan.length_unit, noise_wave(preset.noise_cells, scan)));
  if (!has_limits(preset.limits)) return preset.curve;
  const double wave = std::max(longest_wave(preset, scan), kWaveCellsMin * scan.cell_size);
  return raised(preset.curve, alpha_of_wavelength(scan.length_unit, wave));
}

/// Returns how much of the waves of the noise goes. Relief that bends as sharply as the scan's goes
/// with them, but no more of it than of the noise.
static double noise_part(const Preset& preset, const ScanLengths& scan) {
  if (!scan.noise || scan.sharp_bend == 0) return noisiness(scan);
  const double reach = noise_wave(preset.noise_cells, scan) / (2 * std::numbers::pi);
  const double relief = reach * reach * scan.sharp_bend / scan.length_unit;
  return noisiness(scan) * std::min(1.0, scan.noise->noise / relief);
}

// A form changes by the square of a wave that is short beside it. So a grid that only holds longer
// waves than the preset's gets as much less of β.
static double beta_of(const Preset& preset, const ScanLengths& scan) {
  if (preset.noise_cells > 0) return part_of(noise_part(preset, scan), preset.beta);
  if (!has_limits(preset.limits)) return preset.beta;
  const double held = longest_wave(preset, scan) / (kWaveCellsMin * scan.cell_size);
  const double beta = part_of(std::min(1.0, held * held), preset.beta);
  if (!preset.keeps_edges || scan.can_keep_edges || !scan.noise) return beta;
  return std::clamp(kSharpenedNoiseMax / scan.noise->noise_in_edges(), std::min(1.0, beta), beta);
}

static std::optional<EdgeFilter> edges_of(const Preset& preset, const ScanLengths& scan) {
  if (!preset.bands.empty() || preset.ends_edges) return EdgeFilter{};
  const bool keeps = preset.keeps_edges && scan.can_keep_edges && scan.noise;
  return keeps && scan.noise->filter.is_on() ? std::optional(scan.noise->filter) : std::nullopt;
}

static PresetFilter whole_filter(const Preset& preset, const ScanLengths& scan) {
  return {beta_of(preset, scan), curve_of(preset, scan), bands_of(preset, scan),
          edges_of(preset, scan)};
}

PresetFilter filter_of(const Preset& preset, double strength, const ScanLengths& scan) {
  PresetFilter filter = whole_filter(preset, scan);
  filter.beta = part_of(strength, filter.beta);
  for (Band& band : filter.equaliser.bands) band.gain = part_of(strength, band.gain);
  if (strength == 0 && filter.edges && filter.edges->is_on()) filter.edges.reset();
  return filter;
}

bool changes_edges(const PresetFilter& filter, const EdgeFilter& in_force) {
  return filter.edges && filter.edges->is_on() != in_force.is_on();
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

static bool changes_nothing(const PresetFilter& filter) {
  return filter.beta == 1 &&
         std::ranges::all_of(filter.equaliser.bands, [](const Band& b) { return b.gain == 1; });
}

/// Returns the strength that one of the values tells; 0: none does.
static double told_strength(const PresetFilter& whole, const PresetFilter& values) {
  if (whole.beta != 1) return strength_of_value(values.beta, whole.beta);
  const auto& bands = whole.equaliser.bands;
  if (values.equaliser.bands.size() != bands.size()) return 0;
  for (size_t b = 0; b < bands.size(); ++b)
    if (bands[b].gain != 1) return strength_of_value(values.equaliser.bands[b].gain, bands[b].gain);
  return 0;
}

std::optional<double> strength_of(const Preset& preset, const PresetFilter& values,
                                  const ScanLengths& scan) {
  const PresetFilter whole = whole_filter(preset, scan);
  const bool is_idle = follows_noise(preset) && changes_nothing(whole);
  const double strength = is_idle ? 1 : told_strength(whole, values);
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

static std::string effect_of_bands(const Equaliser& equaliser) {
  std::string text;
  double from = 0;
  for (const Band& band : equaliser.bands) {
    text += text.empty() ? "Waves " : "; those ";
    text += from > 0 ? "from " + length_text(from) + " to " : "under ";
    text += length_text(band.size) + " " + change_text(band.gain);
    from = band.size;
  }
  return text;
}

static std::string effect_of_beta(const Preset& preset, const PresetFilter& whole,
                                  const ScanLengths& scan) {
  if (preset.noise_cells > 0 && whole.beta == 1)
    return "The scan has no noise to speak of: nothing changes";
  if (whole.beta == 1) return "Nothing changes: the noise would grow too, while the volume is kept";
  const std::string length =
      length_text(wavelength_of_alpha(scan.length_unit, lowest_alpha(whole.curve)));
  return (whole.edges ? "Noise goes, edges stay; waves under " : "Waves under ") + length + " " +
         change_text(whole.beta) + (whole.curve.is_constant() ? "" : " where the curve lets them");
}

std::string effect_of(const Preset& preset, const ScanLengths& scan) {
  if (preset.bands.empty() && preset.beta == 1) return "Nothing changes";
  const PresetFilter whole = whole_filter(preset, scan);
  std::string text =
      preset.bands.empty() ? effect_of_beta(preset, whole, scan) : effect_of_bands(whole.equaliser);
  if (follows_noise(preset) && !scan.noise)
    text += preset.keeps_edges ? "; the scan's noise goes first"
                               : "; less where the scan has less noise";
  return text;
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
