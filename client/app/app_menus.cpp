// The part of App that draws the menus.

#include <chrono>

#include "client/app/app.h"
#include "client/app/widgets/depth_list.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/report/depth_text.h"

namespace burnish {

void App::draw_menu_bar() {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  const bool is_drawn = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!is_drawn) return;
  begin_place_group("Menu");
  Workspace& workspace = *workspace_;
  const bool is_open = workspace.document() != nullptr;
  const auto item = [&](const char* label, Action action, bool enabled = true) {
    if (noted(label, ImGui::MenuItem(label, bindings_.key_of(action).c_str(), false, enabled)))
      do_action(action);
  };
  if (noted("File", ImGui::BeginMenu("File"))) {
    item("Open…", Action::kOpen);
    ImGui::Separator();
    item("Export…", Action::kExport, is_open);
    item("Save picture", Action::kScreenshot, is_open);
    if (ImGui::MenuItem("Save picture as…", nullptr, false, is_open)) ask_for_picture();
    ImGui::Separator();
    if (noted("Close session", ImGui::MenuItem("Close session", nullptr, false, is_open)))
      leaving_.begin(Leaving::What::kSession, std::chrono::steady_clock::now());
    draw_depth_menu();
    ImGui::Separator();
    if (noted("Preferences", ImGui::MenuItem("Preferences…"))) preferences_dialog_.open();
    if (ImGui::MenuItem("Quit")) window_->close();
    ImGui::EndMenu();
  }
  if (noted("Edit", ImGui::BeginMenu("Edit", workspace.document() != nullptr))) {
    item("Undo", Action::kUndo);
    item("Redo", Action::kRedo);
    ImGui::EndMenu();
  }
  if (noted("View", ImGui::BeginMenu("View"))) {
    item("Frame all", Action::kFrameAll, workspace.document() != nullptr);
    item("Wireframe", Action::kWireframe, workspace.document() != nullptr);
    item("Split", Action::kSplit, workspace.document() != nullptr);
    noted("Figures", ImGui::MenuItem("Figures", nullptr, &shows_hud_));
    item("Messages", Action::kLog);
    draw_camera_menu();
    ImGui::EndMenu();
  }
  if (noted("Help", ImGui::BeginMenu("Help"))) {
    item("Keys", Action::kHelp);
    ImGui::EndMenu();
  }
  if (Document* const document = workspace.document()) {
    const std::string whole = document->scan().scan.name + " · " + document->session().name;
    const float room = ImGui::GetContentRegionAvail().x - em(3);
    const std::string title = cut_to(whole, room);
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - em(1.6f));
    faint_text("%s", title.c_str());
    if (title != whole) hint(whole.c_str());
  }
  ImGui::EndMainMenuBar();
}

void App::draw_depth_menu() {
  const Document* const document = workspace_->document();
  if (!noted("Open again at depth", ImGui::BeginMenu("Open again at depth", document != nullptr)))
    return;
  const ScanInfo& scan = document->scan().scan;
  const auto choices = depth_choices(scan.statistics, scan.unit, workspace_->server_memory_bytes(),
                                     scan.default_depth);
  faint_text("%s", edges_text(scan.statistics, scan.unit, document->depth()).c_str());
  const auto depth = draw_depth_list(choices, document->depth());
  if (depth && *depth != document->depth()) workspace_->open_again(*depth);
  ImGui::EndMenu();
}

void App::draw_camera_menu() {
  if (!ImGui::BeginMenu("From", workspace_->document() != nullptr)) return;
  for (const ActionInfo& info : actions()) {
    if (info.action < Action::kFront || info.action > Action::kOrthographic) continue;
    if (ImGui::MenuItem(info.description.data(), bindings_.key_of(info.action).c_str()))
      do_action(info.action);
  }
  ImGui::EndMenu();
}

}  // namespace burnish
