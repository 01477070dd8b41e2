#include <algorithm>
#include <vector>

#include "client/model/documents/figures.h"
#include "client/panels/panels.h"
#include "common/edit/proposed_edges.h"

namespace burnish {
namespace {

/// Returns why the server would refuse kept edges; empty if it would not.
const char* bar_to_edges(const Document& document) {
  if (document.edges().is_on()) return "";
  if (!document.equaliser().bands.empty())
    return "Bands have the scan's noise. Remove them to keep edges.";
  if (document.controls().keep_volume) return "The volume stays. Let it change to keep edges.";
  return "";
}

/// Before the presets, in the list of choices.
enum { kOff, kForThisScan, kPresets };

int chosen_edges(const Document& document) {
  if (!document.edges().is_on()) return kOff;
  if (const EdgePreset* const preset = preset_of(document.edges()))
    return kPresets + static_cast<int>(preset - edge_presets().data());
  return document.keeps_edges_by_noise() ? kForThisScan : -1;
}

void choose_edges(Document& document, Widgets& widgets) {
  std::vector<Option> options = {
      {kNoEdges, "Off"},
      {kAutoEdges, "For this scan",
       "As the scan's own noise and edges ask. The server measures them."}};
  std::vector<std::string> hints;
  hints.reserve(edge_presets().size());  // options point at them
  for (const EdgePreset& preset : edge_presets()) {
    hints.push_back("For " + std::string(preset.scans));
    options.push_back({preset.name.data(), preset.title.data(), hints.back().c_str()});
  }
  const int taken = widgets.choice({"Kept edges", options, "Own values"}, chosen_edges(document));
  if (taken == kOff) document.keep_no_edges();
  if (taken == kForThisScan) document.keep_edges_by_noise();
  if (taken >= kPresets)
    document.keep_edges(edge_presets()[static_cast<size_t>(taken - kPresets)].filter);
}

constexpr Slider kStrength = {"Strength of kept edges", "How much of the noise goes", 0, 1};
constexpr Slider kCrispness = {"Crispness", "Low for relief, high for machined parts", 0, 1};
constexpr Slider kAngle = {"Edge angle", "Degrees: sharper bends are edges, and stay",
                           kEdgeAngleMin, kEdgeAngleMax};

SliderChange show_noise_size(double edge, int& passes, Widgets& widgets) {
  double size = noise_size(passes, edge);
  const SliderChange change = widgets.slider(
      {"Noise size",
       "Noise of up to about this length goes, in the scan's units. More takes longer.", edge,
       noise_size(kNormalPassesMax, edge), SliderScale::kLogarithmic},
      size);
  if (change != SliderChange::kStill) passes = passes_of_noise_size(size, edge);
  return change;
}

// Sliders are there at strength 0 too, which a drag may pass.
void show_values(Document& document, Widgets& widgets) {
  EdgeFilter changed = document.edges();
  const SliderChange changes[] = {widgets.slider(kStrength, changed.strength),
                                  widgets.slider(kCrispness, changed.crispness),
                                  widgets.slider(kAngle, changed.edge_angle),
                                  show_noise_size(document.mean_edge(), changed.passes, widgets)};
  follow(std::ranges::max(changes), SetEdges{changed}, document);
}

}  // namespace

void show_edges(Workspace& workspace, Widgets& widgets) {
  Document& document = *workspace.document();
  const char* const bar = bar_to_edges(document);
  widgets.enable(!document.is_viewer() && !*bar);
  widgets.text("Noise goes, edges stay, and what is sharpened is the surface without its noise.");
  widgets.text(bar);
  choose_edges(document, widgets);
  widgets.text(noise_text(document).c_str());
  show_values(document, widgets);
}

}  // namespace burnish
