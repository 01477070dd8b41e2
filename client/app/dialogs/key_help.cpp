#include "client/app/dialogs/key_help.h"

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"

namespace burnish {

static void key_row(const char* key, const char* what) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(theme::kAccent, "%s", key);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(what);
}

static void draw_mouse_rows() {
  key_row("Left", "Paint with the brush");
  key_row("Ctrl+Left", "Paint the opposite: sharpen instead of smooth");
  key_row("Shift+Left", "Restore the original (β = 1)");
  key_row("Middle, Alt+Left", "Turn");
  key_row("Shift+Middle, Right", "Move");
  key_row("Click, right", "Menu of the point: look there, views, its position");
  key_row("Double click, middle", "Turn about the point and come nearer");
  key_row("Ctrl+Shift+Right", "Move the lamp");
  key_row("Wheel", "Zoom at the cursor");
  key_row("Space (hold)", "Show the original");
}

static bool is_of_camera(Action action) {
  return action >= Action::kFront && action <= Action::kTurnDown;
}

static void draw_action_rows(const Bindings& bindings, bool of_camera) {
  for (const ActionInfo& info : actions())
    if (is_of_camera(info.action) == of_camera)
      key_row(bindings.keys_of(info.action).c_str(), info.description.data());
}

static void draw_tables(const Bindings& bindings, bool side_by_side) {
  if (ImGui::BeginTable("##mouse", 2,
                        ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX)) {
    draw_mouse_rows();
    draw_action_rows(bindings, true);
    ImGui::EndTable();
  }
  if (side_by_side) ImGui::SameLine(0, em(2));
  if (ImGui::BeginTable("##keys", 2,
                        ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX)) {
    draw_action_rows(bindings, false);
    ImGui::EndTable();
  }
}

void draw_key_help(const Bindings& bindings, bool& is_open) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, screen);
  if (ImGui::Begin("Keys", &is_open,
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                       ImGuiWindowFlags_NoSavedSettings)) {
    draw_tables(bindings, screen.x > em(75));
    note_window("Keys");
  }
  ImGui::End();
}

}  // namespace burnish
