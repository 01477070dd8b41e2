#include <span>

#include "client/app/panels/painted_choice.h"
#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/value_slider.h"
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
  struct Mode {
    const char* label;
    double value;
  };
  static constexpr Mode kBeta[] = {{"Smooth", 0}, {"Restore", 1}, {"Sharpen", 2}};
  static constexpr Mode kEdges[] = {{"Keep here", 0}, {"Denoise here", 1}};
  const std::span<const Mode> modes = brush.edges ? std::span<const Mode>(kEdges) : kBeta;
  const auto count = static_cast<float>(modes.size());
  const float gaps = (count - 1) * ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gaps) / count;
  for (const Mode& mode : modes) {
    if (&mode != &modes.front()) ImGui::SameLine();
    const bool is_on = brush.beta == mode.value;
    if (is_on)
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    if (noted(mode.label, ImGui::Button(mode.label, {width, 0}))) brush.beta = mode.value;
    if (is_on) ImGui::PopStyleColor();
  }
}

static void draw_reach(Brush& brush) {
  bool through = !brush.connected;
  noted("Through walls", ImGui::Checkbox("Through walls", &through));
  hint(
      "Paints all surface in the ball, the other side of a thin wall too. Without it the brush "
      "paints what hangs together with the place under the pointer.");
  brush.connected = !through;
}

static std::optional<MirrorPlane> plane_of(int chosen, const Document& document) {
  if (chosen == 0) return std::nullopt;
  return MirrorPlane{chosen - 1, document.box().center()[chosen - 1]};
}

static void draw_mirror(Document& document, MessageLog& log) {
  static const char* const kNames[] = {"Off", "Across x", "Across y", "Across z"};
  std::optional<MirrorPlane>& mirror = document.mirror;
  int chosen = mirror ? mirror->axis + 1 : 0;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Mirror");
  hint("Paints each stroke on both sides of a plane, as one step.");
  ImGui::SameLine(em(6));
  ImGui::SetNextItemWidth(-1);
  if (ImGui::Combo("##mirror", &chosen, kNames, IM_ARRAYSIZE(kNames)))
    mirror = plane_of(chosen, document);
  if (!mirror) return;
  const double low = document.box().min()[mirror->axis], high = document.box().max()[mirror->axis];
  linear_slider({{"Mirror plane", low, high}, "%.4g", log}, mirror->at);
}

static void draw_pen(Preferences& preferences) {
  noted("Pen pressure", ImGui::Checkbox("Pen pressure", &preferences.pen_pressure));
  hint("The harder the pen presses, the stronger the brush. Full pressure has the strength above.");
}

static void draw_painted_value(Workspace& workspace) {
  Brush& brush = workspace.document()->brush().brush;
  MessageLog& log = workspace.log;
  draw_painted_choice(workspace);
  if (brush.curve > 0) return;
  if (brush.edges) {
    linear_slider({{"Painted strength", 0, brush.value_max()}, "%.2f", log}, brush.beta);
    return;
  }
  const char* const name = brush.band > 0 ? "Painted gain" : "Painted β";
  beta_slider(name, brush.beta, to_imgui(blue_to_red(signed_part_of_beta(brush.beta))), log);
}

void BrushPanel::draw(Workspace& workspace) {
  Document& document = *workspace.document();
  Brush& brush = document.brush().brush;
  ImGui::BeginDisabled(document.is_viewer());
  ImGui::BeginDisabled(brush.curve > 0);
  draw_mode_buttons(brush);
  ImGui::EndDisabled();
  draw_painted_value(workspace);
  ImGui::TextUnformatted("Radius");
  ImGui::SameLine();
  faint_text("in the scan's units");
  log_slider(
      {{"Radius", 1e-4 * document.diagonal(), 0.5 * document.diagonal()}, "%.3g", workspace.log},
      brush.radius);
  ImGui::TextUnformatted("Strength");
  linear_slider({{"Strength", 0.01, 1}, "%.2f", workspace.log}, brush.strength);
  if (workspace.has_pen) draw_pen(workspace.preferences);
  draw_fall_off(brush);
  draw_reach(brush);
  draw_mirror(document, workspace.log);
  ImGui::EndDisabled();
}

}  // namespace burnish
