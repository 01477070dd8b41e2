#include "client/app/panels/painted_choice.h"

#include <imgui.h>

#include "client/app/widgets/theme.h"
#include "client/tools/band_choice.h"

namespace burnish {
namespace {

constexpr const char* kKeptEdges = "Strength of kept edges";

std::string band_label(const Document& document, int band) {
  return "Gain of " + details_of(document.equaliser(), static_cast<size_t>(band));
}

std::string curve_label(const Document& document, int curve) {
  return "Curve " + document.palette().curves[static_cast<size_t>(curve) - 1].name;
}

/// Undo may have taken the band or the curve away.
void forget_missing(const Document& document, Brush& brush) {
  if (brush.band > static_cast<int>(document.equaliser().bands.size())) brush.band = 0;
  if (brush.curve > static_cast<int>(document.palette().curves.size())) brush.curve = 0;
}

// A strength of kept edges is no β: the brush's β waits among the preferences.
void paint_instead(const std::string& word, Brush& brush, Preferences& preferences) {
  const bool painted_edges = brush.edges;
  if (!painted_edges) preferences.brush_beta = brush.beta;
  (void)parse_painted(word, brush);  // it is a word of ours
  if (brush.edges != painted_edges)
    brush.beta = brush.edges ? brush.value_max() : preferences.brush_beta;
}

std::string painted_label(const Document& document, const Brush& brush) {
  if (brush.band > 0) return band_label(document, brush.band);
  if (brush.curve > 0) return curve_label(document, brush.curve);
  if (brush.edges) return kKeptEdges;
  return brush.colour ? "Gradient scale of colours" : "Gradient scale β";
}

}  // namespace

void draw_painted_choice(Workspace& workspace) {
  Document& document = *workspace.document();
  Brush& brush = document.brush().brush;
  forget_missing(document, brush);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Paints");
  ImGui::SameLine(em(6));
  ImGui::SetNextItemWidth(-1);
  const std::string painted = painted_label(document, brush);
  if (!noted("Paints", ImGui::BeginCombo("##paints", painted.c_str()))) return;
  const auto choose = [&](const std::string& label, const std::string& word) {
    if (noted(label, ImGui::Selectable(label.c_str(), painted_word(brush) == word)))
      paint_instead(word, brush, workspace.preferences);
  };
  choose("Gradient scale β", "beta");
  choose(kKeptEdges, "edges");
  if (document.has_colours()) choose("Gradient scale of colours", "colour");
  for (int band = 1; band <= static_cast<int>(document.equaliser().bands.size()); ++band)
    choose(band_label(document, band), "band:" + std::to_string(band));
  for (int curve = 1; curve <= static_cast<int>(document.palette().curves.size()); ++curve)
    choose(curve_label(document, curve), "curve:" + std::to_string(curve));
  ImGui::EndCombo();
}

}  // namespace burnish
