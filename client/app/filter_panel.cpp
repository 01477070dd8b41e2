#include <algorithm>
#include <cmath>
#include <cstdio>

#include "client/app/panels.h"
#include "client/app/theme.h"
#include "client/app/value_slider.h"
#include "client/tools/colours.h"

namespace burnish {

static void draw_presets(Document& document) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##presets", "Presets", ImGuiComboFlags_HeightLarge)) return;
  for (const Preset& preset : presets()) {
    if (ImGui::Selectable(preset.name.data())) document.apply(preset);
    hint(preset.description.data());
    ImGui::SameLine(em(11));
    faint_text("%s", preset.source.data());
  }
  ImGui::EndCombo();
}

static void draw_beta(Document& document, MessageLog& log) {
  ImGui::TextUnformatted("Gradient scale β");
  ImGui::SameLine();
  faint_text(document.beta() < 1 ? "smooths" : document.beta() > 1 ? "sharpens" : "keeps");
  double beta = document.beta();
  const ImVec4 colour = to_imgui(blue_to_red(signed_part_of_beta(beta)));
  const SliderChange change = beta_slider("Gradient scale β", beta, colour, log);
  if (change != SliderChange::kStill) document.preview_beta(beta);
  if (change == SliderChange::kDone) document.commit_beta();
}

static void draw_fidelity(Document& document, MessageLog& log) {
  ImGui::TextUnformatted("Fidelity α");
  ImGui::SameLine();
  const double unit = document.length_unit();
  double alpha = document.curve().fidelity();
  faint_text("detail size %.3g", detail_size(unit, alpha));
  hint(
      "In the scan's units. Waves on the surface shorter than about six times this size are "
      "smoothed or sharpened; longer waves stay.");
  const SliderChange change =
      log_slider({{"Fidelity α", kFidelityMin, kFidelityMax}, "%.3g", log}, alpha);
  if (change != SliderChange::kStill) {
    document.curve().set_fidelity(alpha);
    document.preview_curve();
  }
  if (change == SliderChange::kDone) document.commit_curve();
  if (alpha > unit / document.cell_size())
    ImGui::TextColored(theme::kBusy, "finer than the grid can resolve");
}

void FilterPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  ImGui::BeginDisabled(document.is_viewer());
  draw_presets(document);
  draw_beta(document, workspace.log);
  draw_fidelity(document, workspace.log);
  ImGui::EndDisabled();
}

}  // namespace burnish
