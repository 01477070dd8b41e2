#include "client/tools/presets.h"

#include <algorithm>
#include <cstdio>

#include "common/edit/wavelength.h"

namespace burnish {

// Makes a curve; high α keeps the surface in place along directions of that curvature.
static TransferCurve curve_of(std::vector<TransferCurve::Point> points) {
  return std::move(TransferCurve::create(std::move(points))).value();
}

static TransferCurve holding_negative(double low, double high) {
  return curve_of({{-60, high}, {-5, low}});
}

static TransferCurve holding_positive(double low, double high) {
  return curve_of({{5, low}, {60, high}});
}

static TransferCurve holding_both(double low, double high) {
  return curve_of({{-60, high}, {-5, low}, {5, low}, {60, high}});
}

static std::vector<Preset> presets_by_purpose() {
  return {
      {"Reduce scanner noise",
       "Smooths the ripple of a few cells that scanners leave",
       0,
       TransferCurve(50),
       6.0,
       {}},
      {"Soften", "Smooths fine detail; large forms stay", 0, TransferCurve(100), {}, {}},
      {"Bring out an inscription",
       "Enhances gentle relief; strong creases hold",
       3,
       holding_both(50, 500),
       {},
       3.0},
      {"Deepen carving",
       "Enhances where the surface bends inwards; ridges hold",
       3,
       holding_positive(25, 500),
       {},
       3.0},
  };
}

static std::vector<Preset> presets_of_paper() {
  return {
      {"Original", "Changes nothing", 1, TransferCurve(50), {}, {}},
      {"Sharpen all", "Enhances detail everywhere", 3, TransferCurve(50), {}, {}},
      {"Sharpen ridges",
       "Enhances where the surface bends outwards; grooves hold",
       3,
       holding_negative(25, 500),
       {},
       {}},
      {"Sharpen grooves",
       "Enhances where the surface bends inwards; ridges hold",
       3,
       holding_positive(25, 500),
       {},
       {}},
      {"Sharpen flats",
       "Enhances gentle relief; strong creases hold",
       3,
       holding_both(25, 500),
       {},
       {}},
      {"Sharpen broadly", "Low fidelity: large forms too", 2, TransferCurve(10), {}, {}},
      {"Sharpen gently", "Higher fidelity: smaller forms", 2, TransferCurve(50), {}, {}},
      {"Smooth gently", "Higher fidelity: smaller forms", 0, TransferCurve(50), {}, {}},
      {"Smooth broadly", "Low fidelity: large forms too", 0, TransferCurve(10), {}, {}},
      {"Keep grooves",
       "Smooths all but sharp concave creases",
       0,
       holding_negative(20, 500),
       {},
       {}},
      {"Keep ridges", "Smooths all but sharp convex creases", 0, holding_positive(20, 500), {}, {}},
      {"Keep creases",
       "Smooths all but sharp creases of both kinds",
       0,
       holding_both(20, 500),
       {},
       {}},
      {"Bring out by brush",
       "Smooths everything; the brush sharpens what it touches",
       0,
       TransferCurve(20),
       {},
       3.0},
  };
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> kPresets = [] {
    std::vector<Preset> all = presets_by_purpose();
    std::ranges::move(presets_of_paper(), std::back_inserter(all));
    return all;
  }();
  return kPresets;
}

const Preset* find_preset(std::string_view name) {
  for (const Preset& preset : presets())
    if (preset.name == name) return &preset;
  return nullptr;
}

PresetFilter filter_of(const Preset& preset, double strength, double length_unit,
                       double cell_size) {
  const double beta = 1 + strength * (preset.beta - 1);
  if (!preset.wave_cells) return {beta, preset.curve};
  const double wavelength = std::max(*preset.wave_cells, kWaveCellsMin) * cell_size;
  return {beta, TransferCurve(alpha_of_wavelength(length_unit, wavelength))};
}

Status check_strength(double strength) {
  if (strength >= 0 && strength <= 1) return Status::ok();
  char text[64];
  std::snprintf(text, sizeof text, "strength %g is outside 0 to 1", strength);
  return invalid_argument(text);
}

}  // namespace burnish
