#include "client/app/painted_choice.h"

#include <imgui.h>

#include "client/app/theme.h"
#include "client/tools/band_choice.h"

namespace burnish {
namespace {

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

std::string painted_label(const Document& document, const Brush& brush) {
  if (brush.band > 0) return band_label(document, brush.band);
  if (brush.curve > 0) return curve_label(document, brush.curve);
  return brush.colour ? "Gradient scale of colours" : "Gradient scale β";
}

}  // namespace

void draw_painted_choice(Document& document) {
  Brush& brush = document.brush().brush;
  forget_missing(document, brush);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Paints");
  ImGui::SameLine(em(6));
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##paints", painted_label(document, brush).c_str())) return;
  const auto choose = [&](const std::string& label, int band, int curve, bool colour = false) {
    const bool is_chosen = brush.band == band && brush.curve == curve && brush.colour == colour;
    if (!ImGui::Selectable(label.c_str(), is_chosen)) return;
    brush.band = band;
    brush.curve = curve;
    brush.colour = colour;
  };
  choose("Gradient scale β", 0, 0);
  if (document.has_colours()) choose("Gradient scale of colours", 0, 0, true);
  for (int band = 1; band <= static_cast<int>(document.equaliser().bands.size()); ++band)
    choose(band_label(document, band), band, 0);
  for (int curve = 1; curve <= static_cast<int>(document.palette().curves.size()); ++curve)
    choose(curve_label(document, curve), 0, curve);
  ImGui::EndCombo();
}

}  // namespace burnish
