#include <cfloat>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/panels.h"
#include "client/app/places.h"
#include "client/app/section_window.h"
#include "client/app/theme.h"
#include "client/report/length_text.h"

namespace burnish {

static void number_row(const char* name, const std::string& value) {
  faint_text("%s", name);
  ImGui::SameLine(em(7.5f));
  ImGui::TextUnformatted(value.c_str());
}

void NumbersPanel::draw_unit(Document& document) {
  if (session_ != document.session().id) unit_ = document.unit();
  session_ = document.session().id;
  ImGui::AlignTextToFramePadding();
  faint_text("unit");
  ImGui::SameLine(em(7.5f));
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##unit", "mm, m, …", &unit_);
  note_place("Unit");
  hint("Names the unit of the scan's coordinates, for everybody who opens the scan.");
  if (ImGui::IsItemDeactivatedAfterEdit() && unit_ != document.unit()) document.name_unit(unit_);
}

static std::string volume_change(const Deviation& deviation) {
  char text[32];
  std::snprintf(text, sizeof text, "%+.3f %%",
                100 * (deviation.volume_after / deviation.volume_before - 1));
  return text;
}

static void draw_deviation(Document& document) {
  document.measuring().follow_deviation(document.shown());
  const auto& measured = document.measuring().deviation();
  if (!measured) return faint_text("measured when the surface has settled");
  const Deviation& deviation = measured->deviation;
  const std::string& unit = document.unit();
  number_row("largest move", length_text(deviation.max, unit));
  number_row("mean", length_text(deviation.mean, unit));
  number_row("rms", length_text(deviation.rms, unit));
  number_row("outwards", length_text(deviation.outward_max, unit));
  number_row("inwards", length_text(deviation.inward_max, unit));
  if (document.scan().scan.statistics.is_closed() && deviation.volume_before != 0)
    number_row("volume", volume_change(deviation));
}

// Roots of the areas, so that a small part is seen beside the part that stays.
static void draw_deviation_histogram(const Document& document) {
  const auto& measured = document.measuring().deviation();
  if (!measured || measured->deviation.is_zero()) return;
  std::array<float, Deviation::kBins> heights;
  for (int bin = 0; bin < Deviation::kBins; ++bin)
    heights[bin] = static_cast<float>(std::sqrt(measured->deviation.histogram[bin]));
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, theme::kAccent);
  ImGui::PlotHistogram("##deviation", heights.data(), Deviation::kBins, 0, nullptr, 0, FLT_MAX,
                       {width, em(4)});
  ImGui::PopStyleColor();
  hint("The surface's area by its move along the normal: inwards left, outwards right.");
  const std::string range = length_text(measured->deviation.histogram_range, document.unit());
  faint_text("-%s", range.c_str());
  ImGui::SameLine(width - ImGui::CalcTextSize(range.c_str()).x);
  faint_text("%s", range.c_str());
}

static void draw_ruler(Document& document, Viewport& viewport) {
  ImGui::Checkbox("Measure", &viewport.measure_mode);
  note_place("Measure");
  hint("Click two points of the surface. The panel shows their distance (M).");
  Ruler& ruler = document.measuring().ruler;
  const auto length = ruler.length();
  if (!length) {
    if (viewport.measure_mode) faint_text(ruler.ends().empty() ? "first point" : "second point");
    return;
  }
  number_row("distance", length_text(*length, document.unit()));
  number_row("on the original", length_text(*ruler.original_length(), document.unit()));
  if (noted("Section", ImGui::Button("Section")))
    document.measuring().cut(section_plane(ruler, viewport.camera));
  hint("Cuts the surface along the ruler, in the direction of the view.");
  ImGui::SameLine();
  if (noted("Clear", ImGui::Button("Clear"))) ruler.clear();
}

void NumbersPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  draw_unit(document);
  draw_deviation(document);
  draw_deviation_histogram(document);
  draw_ruler(document, workspace.viewport);
}

}  // namespace burnish
