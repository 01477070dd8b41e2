#include "client/app/dialogs/preferences_dialog.h"

#include <cmath>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <string>
#include <utility>

#include "client/app/widgets/escape.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"

namespace burnish {

static constexpr const char* kPreferencesTitle = "Preferences";
static constexpr float kNameEm = 8, kChoiceEm = 14;
static constexpr double kScales[] = {0, 1, 1.25, 1.5, 2, 2.5, 3};  // 0: the screen's

static void begin_row(const char* label) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::SameLine(em(kNameEm));
  ImGui::SetNextItemWidth(em(kChoiceEm));
}

static std::string scale_text(double scale) {
  if (scale == 0) return "As the screen";
  return std::to_string(std::lround(100 * scale)) + " %";
}

static void draw_scale(double& scale) {
  begin_row("Size");
  if (noted("Size", ImGui::BeginCombo("##scale", scale_text(scale).c_str()))) {
    for (const double each : kScales)
      if (noted(scale_text(each), ImGui::Selectable(scale_text(each).c_str(), each == scale)))
        scale = each;
    ImGui::EndCombo();
  }
  hint("The size of letters and panels.");
}

static void draw_theme(Preferences& preferences) {
  begin_row("Colours");
  const char* const shown = preferences.light_theme ? "Light" : "Dark";
  if (noted("Colours", ImGui::BeginCombo("##theme", shown))) {
    if (noted("Dark", ImGui::Selectable("Dark", !preferences.light_theme)))
      preferences.light_theme = false;
    if (noted("Light", ImGui::Selectable("Light", preferences.light_theme)))
      preferences.light_theme = true;
    ImGui::EndCombo();
  }
  hint("The colours of the panels.");
}

void PreferencesDialog::draw(Workspace& workspace) {
  if (std::exchange(opening_, false)) ImGui::OpenPopup(kPreferencesTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  constexpr auto kFlags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;
  if (!ImGui::BeginPopupModal(kPreferencesTitle, nullptr, kFlags)) return;
  begin_place_group("Preferences");
  Preferences& preferences = workspace.preferences;
  draw_theme(preferences);
  draw_scale(preferences.scale);
  begin_row("Your name");
  ImGui::InputText("##user", &preferences.user);
  note_place("Your name");
  hint("The author of your edits. It counts from the next connection on.");
  ImGui::Checkbox("Use the desktop's file dialogs", &preferences.native_dialogs);
  note_place("Desktop dialogs");
  hint("zenity or kdialog, where one is installed.");
  ImGui::Dummy({0, em(0.3f)});
  const bool is_over = noted("Close", ImGui::Button("Close", {em(8), 0})) || is_escaped();
  if (is_over) {
    workspace.save_preferences();
    ImGui::CloseCurrentPopup();
  }
  note_window("Preferences");
  ImGui::EndPopup();
}

}  // namespace burnish
