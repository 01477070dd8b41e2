#include "client/app/export_dialog.h"

#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/theme.h"

namespace burnish {

static constexpr const char* kExportTitle = "Export the edited scan";

static std::string suggested_path(const Document& document) {
  std::error_code error;
  const auto folder = std::filesystem::current_path(error);
  return (folder / (document.scan().scan.name + "-edited.ply")).string();
}

void ExportDialog::draw(Workspace& workspace) {
  if (std::exchange(opening_, false)) {
    if (path_.empty()) path_ = suggested_path(*workspace.document());
    ImGui::OpenPopup(kExportTitle);
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  open_ = ImGui::BeginPopupModal(kExportTitle, nullptr, ImGuiWindowFlags_AlwaysAutoResize);
  if (!open_) return;
  ImGui::TextUnformatted("File (.ply, .obj or .stl)");
  ImGui::SetNextItemWidth(em(32));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::InputText("##path", &path_);
  ImGui::Checkbox("Exact", &exact_);
  hint("Solves until the surface is within 1e-5 of the diagonal; this takes longer.");
  const bool wanted = ImGui::Button("Export", {em(8), 0});
  ImGui::SameLine();
  const bool unwanted = ImGui::Button("Cancel", {em(8), 0}) ||
                        ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (wanted) workspace.export_mesh(path_, exact_);
  if (wanted || unwanted) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace burnish
