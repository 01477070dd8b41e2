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
       .description = "Smooths the ripple that scanners leave, as far as the scan has it",
       .beta = 0,
       .noise_cells = 4},
      {.name = "Soften",
       .description = "Smooths fine detail; forms stay",
       .beta = 0,
       .curve = TransferCurve(20),
       .limits = {.cells = 10, .radii = 0.7, .units = 0.1}},
      {.name = "Bring out an inscription",
       .description = "Raises what is as wide as letters; noise and large forms do not grow",
       .bands = {{.cells = 6, .gain = 0}, {.alpha = 100, .gain = 2.5}}},
      {.name = "Deepen carving",
       .description = "Raises lines and reliefs up to a tenth of the scan; noise does not grow",
       .bands = {{.cells = 6, .gain = 0}, {.alpha = 60, .gain = 2}}},
  };
}

// Smoothing by a longer wave melts what is narrow, and sharpening by it swells it. A wave of 1.5
// times the radius of a rod changes it by 5 %, and one of 0.15 L a sphere by 1.5 %, times β - 1.
static constexpr WaveLimits kFine = {.radii = 1, .units = 0.1};
static constexpr WaveLimits kUsual = {.radii = 1.2, .units = 0.12};
static constexpr WaveLimits kBroad = {.radii = 1.5, .units = 0.15};

static Preset smoothing(const char* name, const char* description, TransferCurve curve,
                        const WaveLimits& limits) {
  return {.name = name,
          .description = description,
          .beta = 0,
          .curve = std::move(curve),
          .limits = limits};
}

static Preset sharpening(const char* name, const char* description, double beta,
                         TransferCurve curve, const WaveLimits& limits) {
  return {.name = name,
          .description = description,
          .beta = beta,
          .curve = std::move(curve),
          .limits = limits,
          .keeps_edges = true};
}

static std::vector<Preset> presets_of_paper() {
  Preset by_brush =
      smoothing("Bring out by brush", "Smooths everything; the brush sharpens what it touches",
                TransferCurve(20), kUsual);
  by_brush.brush_beta = 3;
  return {
      {.name = "Original",
       .description = "Changes nothing",
       .beta = 1,
       .curve = TransferCurve(50),
       .ends_edges = true},
      sharpening("Sharpen all", "Enhances detail everywhere", 3, TransferCurve(50), kUsual),
      sharpening("Sharpen ridges", "Enhances where the surface bends outwards; grooves hold", 3,
                 holding_negative(25, 500), kFine),
      sharpening("Sharpen grooves", "Enhances where the surface bends inwards; ridges hold", 3,
                 holding_positive(25, 500), kFine),
      sharpening("Sharpen flats", "Enhances gentle relief; strong creases hold", 3,
                 holding_both(25, 500), kFine),
      sharpening("Sharpen broadly", "Low fidelity: larger forms too", 2, TransferCurve(10), kBroad),
      sharpening("Sharpen gently", "Higher fidelity: smaller forms", 2, TransferCurve(50), kFine),
      smoothing("Smooth gently", "Higher fidelity: smaller forms", TransferCurve(50), kFine),
      smoothing("Smooth broadly", "Low fidelity: larger forms too", TransferCurve(10), kBroad),
      smoothing("Keep grooves", "Smooths all but sharp concave creases", holding_negative(20, 500),
                kUsual),
      smoothing("Keep ridges", "Smooths all but sharp convex creases", holding_positive(20, 500),
                kUsual),
      smoothing("Keep creases", "Smooths all but sharp creases of both kinds",
                holding_both(20, 500), kUsual),
      std::move(by_brush),
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
