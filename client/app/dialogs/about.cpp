#include "client/app/dialogs/about.h"

#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/report/about_text.h"

namespace burnish {

void draw_about(bool& is_open) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  if (ImGui::Begin("About Burnish", &is_open,
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                       ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::PushTextWrapPos(em(32));
    for (const AboutText& about : about_texts()) {
      faint_text("%s", about.title.c_str());
      ImGui::TextUnformatted(about.text.c_str());
      ImGui::Dummy({0, em(0.3f)});
    }
    ImGui::PopTextWrapPos();
    note_window("About Burnish");
  }
  ImGui::End();
}

}  // namespace burnish
