#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
#include "client/model/documents/figures.h"

namespace burnish {
namespace {

constexpr const char* kForThisScan = "For this scan";

void draw_presets(Document& document) {
  const EdgeFilter& edges = document.edges();
  const EdgePreset* const shown = preset_of(edges);
  const char* const own = document.keeps_edges_by_noise() ? kForThisScan : "Own values";
  const std::string title(!edges.is_on() ? "Off" : shown ? shown->title : own);
  ImGui::SetNextItemWidth(-1);
  if (!noted("Kept edges", ImGui::BeginCombo("##edges", title.c_str()))) return;
  if (noted("Keep no edges", ImGui::Selectable("Off", !edges.is_on()))) document.keep_no_edges();
  const bool is_by_noise = !shown && document.keeps_edges_by_noise();
  if (noted(kForThisScan, ImGui::Selectable(kForThisScan, is_by_noise)))
    document.keep_edges_by_noise();
  hint("As the scan's own noise and edges ask. The server measures them.");
  for (const EdgePreset& preset : edge_presets()) {
    const std::string name(preset.title);
    if (noted(name, ImGui::Selectable(name.c_str(), edges.is_on() && shown == &preset)))
      document.keep_edges(preset.filter);
    hint(("For " + std::string(preset.scans)).c_str());
  }
  ImGui::EndCombo();
}

SliderChange draw_value(const char* name, const char* meaning, double least, double most,
                        double& value, MessageLog& log) {
  ImGui::TextUnformatted(name);
  hint(meaning);
  return linear_slider({{name, least, most}, "%.3g", log}, value);
}

SliderChange draw_noise_size(const Document& document, int& passes, MessageLog& log) {
  const double edge = document.mean_edge();
  double size = noise_size(passes, edge);
  ImGui::TextUnformatted("Noise size");
  hint("Noise of up to about this length goes, in the scan's units. More takes longer.");
  const SliderChange change =
      log_slider({{"Noise size", edge, noise_size(kNormalPassesMax, edge)}, "%.3g", log}, size);
  if (change != SliderChange::kStill) passes = passes_of_noise_size(size, edge);
  return change;
}

void draw_values(Document& document, MessageLog& log) {
  EdgeFilter changed = document.edges();
  SliderChange change = draw_value("Strength of kept edges", "How much of the noise goes", 0, 1,
                                   changed.strength, log);
  change = std::max(change, draw_value("Crispness", "Low for relief, high for machined parts", 0, 1,
                                       changed.crispness, log));
  change = std::max(change, draw_value("Edge angle", "Degrees: sharper bends are edges, and stay",
                                       kEdgeAngleMin, kEdgeAngleMax, changed.edge_angle, log));
  change = std::max(change, draw_noise_size(document, changed.passes, log));
  if (change == SliderChange::kMoving) document.preview(SetEdges{changed});
  if (change == SliderChange::kDone) document.commit(SetEdges{changed});
}

/// Returns why the server would refuse kept edges; null if it would not.
const char* bar_to_edges(const Document& document) {
  if (document.edges().is_on()) return nullptr;
  if (!document.equaliser().bands.empty())
    return "Bands have the scan's noise. Remove them to keep edges.";
  if (document.controls().keep_volume) return "The volume stays. Let it change to keep edges.";
  return nullptr;
}

}  // namespace

void EdgesPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  const char* const bar = bar_to_edges(document);
  ImGui::BeginDisabled(document.is_viewer() || bar);
  faint_text("%s",
             "Noise goes, edges stay, and what is sharpened is the surface without its noise.");
  if (bar) faint_text("%s", bar);
  draw_presets(document);
  if (const std::string noise = noise_text(document); !noise.empty())
    faint_text("%s", noise.c_str());
  draw_values(document, workspace.log);  // also at strength 0, which a drag may pass
  ImGui::EndDisabled();
}

}  // namespace burnish
