#include "client/app/panels.h"
#include "client/app/theme.h"
#include "client/app/value_slider.h"
#include "client/tools/colours.h"

namespace burnish {

static void draw_fall_off(Brush& brush) {
  static const char* const kNames[] = {"Smooth", "Linear", "Sharp", "Constant"};  // as FallOff
  int chosen = static_cast<int>(brush.fall_off);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Fall-off");
  ImGui::SameLine(em(6));
  ImGui::SetNextItemWidth(-1);
  if (ImGui::Combo("##falloff", &chosen, kNames, IM_ARRAYSIZE(kNames)))
    brush.fall_off = static_cast<FallOff>(chosen);
}

static void draw_mode_buttons(Brush& brush) {
  const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  const auto button = [&](const char* label, double beta) {
    const bool is_on = brush.beta == beta;
    if (is_on)
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (ImGui::Button(label, {third, 0})) brush.beta = beta;
    if (is_on) ImGui::PopStyleColor();
  };
  button("Smooth", 0);
  ImGui::SameLine();
  button("Restore", 1);
  ImGui::SameLine();
  button("Sharpen", 2);
}

void BrushPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  Brush& brush = document.brush().brush;
  ImGui::BeginDisabled(document.is_viewer());
  draw_mode_buttons(brush);
  ImGui::TextUnformatted("Painted β");
  beta_slider("Painted β", brush.beta, to_imgui(blue_to_red(signed_part_of_beta(brush.beta))),
              workspace.log);
  ImGui::TextUnformatted("Radius");
  ImGui::SameLine();
  faint_text("in the scan's units");
  log_slider(
      {{"Radius", 1e-4 * document.diagonal(), 0.5 * document.diagonal()}, "%.3g", workspace.log},
      brush.radius);
  ImGui::TextUnformatted("Strength");
  linear_slider({{"Strength", 0.01, 1}, "%.2f", workspace.log}, brush.strength);
  draw_fall_off(brush);
  ImGui::EndDisabled();
}

}  // namespace burnish
