#include "client/app/start_page.h"

#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "client/app/start_page_lists.h"
#include "client/app/theme.h"
#include "client/model/typed_path.h"

namespace burnish {

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

void StartPage::draw_server(Workspace& workspace) {
  ImGui::TextUnformatted("Server");
  if (ImGui::Button("Use this computer", {-1, 0})) workspace.connect_privately();
  hint("Starts your own server, which keeps its scans in your home folder.");
  ImGui::SetNextItemWidth(-em(6));
  const bool entered = ImGui::InputTextWithHint("##server", "HOST:PORT", &server_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  ImGui::BeginDisabled(server_.empty());
  if (ImGui::Button("Connect", {-1, 0}) || (entered && !server_.empty()))
    workspace.connect(server_);
  ImGui::EndDisabled();
  draw_state(workspace.library());
}

void StartPage::draw_recent(Workspace& workspace) const {
  ImGui::TextUnformatted("Recent");
  if (workspace.preferences.recent.empty()) faint_text("nothing opened yet");
  for (const RecentSession& recent : workspace.preferences.recent) {
    ImGui::PushID(&recent);
    if (ImGui::Selectable(recent.session.c_str())) {
      workspace.reopen(RecentSession(recent));
      ImGui::PopID();
      return;  // the list has changed
    }
    ImGui::SameLine(em(10));
    faint_text("%s", recent.server.empty() ? "this computer" : recent.server.c_str());
    ImGui::PopID();
  }
}

void StartPage::draw_import(Workspace& workspace) {
  ImGui::TextUnformatted("Import a scan");
  ImGui::SetNextItemWidth(-em(6));
  const bool entered = ImGui::InputTextWithHint("##file", "file: .ply, .obj, .stl, .off", &file_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if ((ImGui::Button("Import", {-1, 0}) || entered) && !file_.empty())
    workspace.import_scan(typed_path(file_));
  faint_text("or drop files on the window");
}

void StartPage::draw(Workspace& workspace) {
  if (std::exchange(is_first_, false)) server_ = workspace.preferences.server;
  const float width = ImGui::GetContentRegionAvail().x;
  const float left = std::max(em(20), 0.34f * width);
  ImGui::SetCursorPosY(em(1.2f));
  ImGui::PushFont(title_font());
  ImGui::TextUnformatted("Burnish");
  ImGui::PopFont();
  faint_text("smooths and sharpens scanned surfaces");
  ImGui::Dummy({0, em(0.6f)});
  ImGui::BeginChild("##left", {left, 0});
  draw_server(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_import(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_recent(workspace);
  ImGui::EndChild();
  ImGui::SameLine(0, em(1.6f));
  ImGui::BeginChild("##right");
  draw_scans(workspace);
  ImGui::Dummy({0, em(0.8f)});
  draw_sessions(workspace);
  ImGui::EndChild();
}

}  // namespace burnish
