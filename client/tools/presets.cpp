#include "client/tools/presets.h"

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

const std::vector<Preset>& presets() {
  static const std::vector<Preset> kPresets = {
      {"Original", "Figure 2", "Nothing is changed", 1, TransferCurve(50), {}},
      {"Sharpen all", "Figure 1b", "Detail everywhere is enhanced", 3, TransferCurve(50), {}},
      {"Sharpen ridges",
       "Figure 1c",
       "Enhances where the surface bends outwards; grooves hold",
       3,
       holding_negative(25, 500),
       {}},
      {"Sharpen grooves",
       "Figure 1d",
       "Enhances where the surface bends inwards; ridges hold",
       3,
       holding_positive(25, 500),
       {}},
      {"Sharpen flats",
       "Figure 1e",
       "Enhances gentle relief; strong creases hold",
       3,
       holding_both(25, 500),
       {}},
      {"Sharpen broadly", "Figure 2", "Low fidelity: large forms too", 2, TransferCurve(10), {}},
      {"Sharpen gently", "Figure 2", "Higher fidelity: smaller forms", 2, TransferCurve(50), {}},
      {"Smooth gently", "Figure 2", "Higher fidelity: smaller forms", 0, TransferCurve(50), {}},
      {"Smooth broadly", "Figure 2", "Low fidelity: large forms too", 0, TransferCurve(10), {}},
      {"Keep grooves",
       "Figure 3",
       "Smooths all but sharp concave creases",
       0,
       holding_negative(20, 500),
       {}},
      {"Keep ridges",
       "Figure 3",
       "Smooths all but sharp convex creases",
       0,
       holding_positive(20, 500),
       {}},
      {"Keep creases",
       "Figure 3",
       "Smooths all but sharp creases of both kinds",
       0,
       holding_both(20, 500),
       {}},
      {"Bring out by brush", "Figure 5", "Smooths everything; the brush sharpens what it touches",
       0, TransferCurve(20), 3.0},
  };
  return kPresets;
}

const Preset* find_preset(std::string_view name) {
  for (const Preset& preset : presets())
    if (preset.name == name) return &preset;
  return nullptr;
}

}  // namespace burnish
