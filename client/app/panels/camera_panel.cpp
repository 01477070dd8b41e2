#include "client/app/panels/panels.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"

namespace burnish {

static void draw_up(Viewport& viewport) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Up");
  hint("The scan's axis that points up. It is kept with the session.");
  ImGui::SameLine(em(3));
  ImGui::SetNextItemWidth(-1);
  const std::string chosen(name_of(viewport.camera.up));
  if (!ImGui::BeginCombo("##up", chosen.c_str())) return;
  for (int i = 0; i < kUpAxes; ++i) {
    const auto up = static_cast<UpAxis>(i);
    if (ImGui::Selectable(name_of(up).data(), up == viewport.camera.up)) viewport.set_up(up);
  }
  ImGui::EndCombo();
}

static void draw_standard_views(Viewport& viewport) {
  static constexpr const char* kNames[] = {"Front", "Back", "Right", "Left", "Top", "Bottom"};
  const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  for (int i = 0; i < kStandardViews; ++i) {
    if (i % 3 != 0) ImGui::SameLine();
    if (ImGui::Button(kNames[i], {third, 0})) viewport.show_from(static_cast<StandardView>(i));
  }
}

void CameraPanel::draw(Workspace& workspace) {
  Viewport& viewport = workspace.viewport;
  draw_up(viewport);
  draw_standard_views(viewport);
  ImGui::Checkbox("Orthographic", &viewport.camera.orthographic);
  note_place("Orthographic");
  hint("Draws without perspective: equal lengths are equal in the picture.");
}

}  // namespace burnish
