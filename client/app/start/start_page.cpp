#include "client/app/start/start_page.h"

#include <algorithm>
#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/start/start_page_lists.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/model/files/typed_path.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

static constexpr float kSideBySideEm = 56;              // least width of two columns
static constexpr float kOpenEm = 17.5f, kListsEm = 30;  // heights in one column, which scrolls

static void draw_state(const Library& library) {
  const char* const where = library.is_private ? "this computer" : library.server.c_str();
  switch (library.state) {
    case Library::State::kUnconnected:
      faint_text("not connected");
      break;
    case Library::State::kConnecting:
      ImGui::TextColored(theme::kBusy, "connecting to %s…", where);
      break;
    case Library::State::kConnected:
      ImGui::TextColored(theme::kGood, "connected to %s", where);
      break;
    case Library::State::kFailed:
      ImGui::PushStyleColor(ImGuiCol_Text, theme::kBad);
      ImGui::TextWrapped("%s", library.problem.c_str());
      ImGui::PopStyleColor();
      break;
  }
}

void StartPage::draw_open(Workspace& workspace) {
  for (const ImGuiCol each : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
    ImGui::PushStyleColor(each, theme::kStrong);
  ImGui::PushStyleColor(ImGuiCol_Text, theme::kOnStrong);
  ImGui::PushFont(title_font());
  if (noted("Open a scan", ImGui::Button("Open a scan…", {-1, em(4)}))) wants_to_open_ = true;
  ImGui::PopFont();
  ImGui::PopStyleColor(4);
  hint(("Chooses a mesh file: " + extensions_text() + " (Ctrl+O).").c_str());
  faint_text("or drop a file on the window, or type its path");
  ImGui::SetNextItemWidth(-em(5));
  const bool entered = ImGui::InputTextWithHint("##file", "~/scans/head.ply", &file_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  note_place("Path");
  hint("The path of a mesh file; ~ is your home folder.");
  ImGui::SameLine();
  if ((ImGui::Button("Open", {-1, 0}) || entered) && !file_.empty())
    workspace.import_scan(typed_path(file_));
}

void StartPage::draw_server(Workspace& workspace) {
  ImGui::TextUnformatted("Server");
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  if (ImGui::Button("Use this computer", {half, 0})) workspace.connect_privately();
  hint("Starts your own server, which keeps its scans in your home folder.");
  ImGui::SameLine();
  if (noted("Another server", ImGui::Button("Another server…", {half, 0})))
    connection_dialog_.open();
  hint("Connects to a server that others may use too.");
  draw_state(workspace.library());
}

void StartPage::draw(Workspace& workspace) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool is_wide = width > em(kSideBySideEm);
  const float left = is_wide ? std::max(em(20), 0.34f * width) : width;
  ImGui::SetCursorPosY(em(1.2f));
  ImGui::PushFont(title_font());
  ImGui::TextUnformatted("Burnish");
  ImGui::PopFont();
  faint_text("smooths and sharpens scanned surfaces");
  ImGui::Dummy({0, em(0.6f)});
  ImGui::BeginChild("##left", {left, is_wide ? 0 : em(kOpenEm)});
  draw_open(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_server(workspace);
  note_window("Open and server");
  ImGui::EndChild();
  if (is_wide) ImGui::SameLine(0, em(1.6f));
  ImGui::BeginChild("##right", {0, is_wide ? 0 : em(kListsEm)});
  ImGui::TextUnformatted("Recent");
  cards_.draw(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_scans(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_sessions(workspace);
  note_window("Lists");
  ImGui::EndChild();
  connection_dialog_.draw(workspace);
}

}  // namespace burnish
