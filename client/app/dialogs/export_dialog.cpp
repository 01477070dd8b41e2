#include "client/app/dialogs/export_dialog.h"

#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/widgets/escape.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/model/files/typed_path.h"
#include "common/mesh/export_formats.h"

namespace burnish {

static constexpr const char* kExportTitle = "Export the edited scan";

static std::string suggested_path(const Workspace& workspace) {
  std::error_code error;
  const auto& folders = workspace.preferences.folders;
  const auto folder = folders.empty() ? std::filesystem::current_path(error) : folders.front();
  const ScanInfo& scan = workspace.document()->scan().scan;
  const std::string extension = extension_of(export_formats(scan.format).front());
  return (folder / (scan.name + "-edited" + extension)).string();
}

static std::string title_of_path(const ScanInfo& scan) {
  std::string text;
  for (const MeshFormat format : export_formats(scan.format))
    text += (text.empty() ? "File (" : ", ") + extension_of(format);
  return text + ")";
}

void ExportDialog::open(const std::filesystem::path& file) {
  path_ = file.string();
  is_path_chosen_ = opening_ = true;
}

void ExportDialog::draw(Workspace& workspace) {
  if (std::exchange(opening_, false)) {
    const Document& document = *workspace.document();
    const bool is_chosen = std::exchange(is_path_chosen_, false);
    if (!is_chosen && session_ != document.session().id) path_ = suggested_path(workspace);
    session_ = document.session().id;
    asks_ = false;
    ImGui::OpenPopup(kExportTitle);
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  begin_place_group("Export");
  open_ = ImGui::BeginPopupModal(kExportTitle, nullptr, ImGuiWindowFlags_AlwaysAutoResize);
  if (!open_) return;
  ImGui::TextUnformatted(title_of_path(workspace.document()->scan().scan).c_str());
  ImGui::SetNextItemWidth(em(32));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  bool wanted = ImGui::InputText(
      "##path", &path_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemEdited()) asks_ = false;
  hint("The path of the file; its end chooses the format. ~ is your home folder.");
  ImGui::SameLine();
  const bool browses = ImGui::Button("Browse…");
  hint("Chooses the file in a dialog.");
  if (browses)
    question_ = {FileQuestion::Purpose::kSave, "Export to", mesh_extensions(), typed_path(path_)};
  ImGui::Checkbox("Exact", &exact_);
  note_place("Exact");
  hint("Solves until the surface is within 1e-5 of the diagonal; this takes longer.");
  ImGui::Checkbox("Processing record", &with_record_);
  note_place("Processing record");
  hint(
      "Also writes who did what, how far the surface moved, and the hashes of both files: a page "
      "to "
      "print and JSON, beside the file.");
  if (asks_) ImGui::TextColored(theme::kBusy, "The file is there already.");
  wanted |=
      noted("Export", ImGui::Button(asks_ ? "Replace" : "Export", {em(8), 0})) && !path_.empty();
  ImGui::SameLine();
  const bool unwanted = ImGui::Button("Cancel", {em(8), 0}) || is_escaped();
  if (unwanted || browses || (wanted && start_export(workspace))) ImGui::CloseCurrentPopup();
  note_window("Export");
  ImGui::EndPopup();
}

// Asks before it replaces a file.
bool ExportDialog::start_export(Workspace& workspace) {
  const std::filesystem::path file = typed_path(path_);
  std::error_code ignored;
  if (!std::exchange(asks_, true) && std::filesystem::exists(file, ignored)) return false;
  asks_ = false;
  workspace.export_mesh(file, exact_, with_record_);
  remember_folder(workspace.preferences, file.parent_path());
  return true;
}

}  // namespace burnish
