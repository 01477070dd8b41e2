#include "client/tools/presets.h"

#include <algorithm>
#include <cstdio>

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

// Scanners leave a ripple of a few cells. The letters of an inscription and the lines of a carving
// are longer waves, which are a part of the scan.
static std::vector<Preset> presets_by_purpose() {
  return {
      {.name = "Reduce scanner noise",
       .description = "Smooths the ripple of a few cells that scanners leave",
       .beta = 0,
       .wave_cells = 4},
      {.name = "Soften",
       .description = "Smooths fine detail; large forms stay",
       .beta = 0,
       .wave_cells = 10},
      {.name = "Bring out an inscription",
       .description = "Raises what is as wide as letters; noise and large forms do not grow",
       .bands = {{.cells = 6, .gain = 0}, {.alpha = 100, .cells = 12, .gain = 2.5}}},
      {.name = "Deepen carving",
       .description = "Raises lines and reliefs up to a tenth of the scan; noise does not grow",
       .bands = {{.cells = 6, .gain = 0}, {.alpha = 60, .cells = 12, .gain = 2}}},
  };
}

static std::vector<Preset> presets_of_paper() {
  return {
      {.name = "Original", .description = "Changes nothing", .beta = 1, .curve = TransferCurve(50)},
      {.name = "Sharpen all",
       .description = "Enhances detail everywhere",
       .beta = 3,
       .curve = TransferCurve(50)},
      {.name = "Sharpen ridges",
       .description = "Enhances where the surface bends outwards; grooves hold",
       .beta = 3,
       .curve = holding_negative(25, 500)},
      {.name = "Sharpen grooves",
       .description = "Enhances where the surface bends inwards; ridges hold",
       .beta = 3,
       .curve = holding_positive(25, 500)},
      {.name = "Sharpen flats",
       .description = "Enhances gentle relief; strong creases hold",
       .beta = 3,
       .curve = holding_both(25, 500)},
      {.name = "Sharpen broadly",
       .description = "Low fidelity: large forms too",
       .beta = 2,
       .curve = TransferCurve(10)},
      {.name = "Sharpen gently",
       .description = "Higher fidelity: smaller forms",
       .beta = 2,
       .curve = TransferCurve(50)},
      {.name = "Smooth gently",
       .description = "Higher fidelity: smaller forms",
       .beta = 0,
       .curve = TransferCurve(50)},
      {.name = "Smooth broadly",
       .description = "Low fidelity: large forms too",
       .beta = 0,
       .curve = TransferCurve(10)},
      {.name = "Keep grooves",
       .description = "Smooths all but sharp concave creases",
       .beta = 0,
       .curve = holding_negative(20, 500)},
      {.name = "Keep ridges",
       .description = "Smooths all but sharp convex creases",
       .beta = 0,
       .curve = holding_positive(20, 500)},
      {.name = "Keep creases",
       .description = "Smooths all but sharp creases of both kinds",
       .beta = 0,
       .curve = holding_both(20, 500)},
      {.name = "Bring out by brush",
       .description = "Smooths everything; the brush sharpens what it touches",
       .beta = 0,
       .curve = TransferCurve(20),
       .brush_beta = 3.0},
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

Status check_strength(double strength) {
  if (strength >= 0 && strength <= 1) return Status::ok();
  char text[64];
  std::snprintf(text, sizeof text, "strength %g is outside 0 to 1", strength);
  return invalid_argument(text);
}

}  // namespace burnish
