#include <cfloat>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/model/documents/figures.h"
#include "client/model/view/section_view.h"
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

static void number_rows(const std::vector<Figure>& figures) {
  for (const Figure& figure : figures) number_row(figure.name.c_str(), figure.value);
}

static void draw_deviation(Document& document, UpAxis up) {
  document.measuring().follow_deviation(document.shown());
  if (!document.measuring().deviation()) return faint_text("measured when the surface has settled");
  const bool is_current = document.measuring().is_deviation_of(document.shown());
  ImGui::BeginDisabled(!is_current);
  number_rows(deviation_figures(document, up));
  ImGui::EndDisabled();
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
  if (!ruler.length()) {
    if (viewport.measure_mode) faint_text(ruler.ends().empty() ? "first point" : "second point");
    return;
  }
  number_rows(ruler_figures(document));
  if (noted("Section", ImGui::Button("Section")))
    document.measuring().cut(section_plane(ruler, viewport.camera));
  hint("Cuts the surface along the ruler, in the direction of the view.");
  ImGui::SameLine();
  if (noted("Clear", ImGui::Button("Clear"))) ruler.clear();
}

void NumbersPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  draw_unit(document);
  draw_deviation(document, workspace.viewport.camera.up);
  draw_deviation_histogram(document);
  draw_ruler(document, workspace.viewport);
}

}  // namespace burnish
