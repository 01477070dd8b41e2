#include "client/app/key_help.h"

#include "client/app/theme.h"

namespace burnish {

static void row(const char* key, const char* what) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(theme::kAccent, "%s", key);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(what);
}

static void draw_mouse_rows() {
  row("Left", "Paint with the brush");
  row("Ctrl+Left", "Paint the opposite: sharpen instead of smooth");
  row("Shift+Left", "Restore the original (β = 1)");
  row("Middle, Alt+Left", "Turn");
  row("Shift+Middle, Right", "Move");
  row("Wheel", "Zoom at the cursor");
  row("Space (hold)", "Show the original");
}

void draw_key_help(const Bindings& bindings, bool& is_open) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("Keys", &is_open,
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                       ImGuiWindowFlags_NoSavedSettings)) {
    if (ImGui::BeginTable("##keys", 2, ImGuiTableFlags_SizingFixedFit)) {
      draw_mouse_rows();
      for (const ActionInfo& info : actions())
        row(bindings.key_of(info.action).c_str(), info.description.data());
      ImGui::EndTable();
    }
  }
  ImGui::End();
}

}  // namespace burnish
