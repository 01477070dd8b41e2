#include <algorithm>

#include "client/app/app.h"
#include "client/app/dialogs/key_help.h"
#include "client/app/dialogs/leave_question.h"
#include "client/app/overlay/ruler_overlay.h"
#include "client/app/panels/raw_facts.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"

namespace burnish {

static constexpr ImGuiWindowFlags kFixed =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void App::draw_panels() {
  draw_menu_bar();
  if (workspace_->has_picture()) {
    draw_session_page();
  } else {
    picture_ = {};
    draw_start_page();
  }
  draw_overlays();
}

// The columns with the panels, and the picture's place between them.
void App::draw_session_page() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  const float top = ImGui::GetFrameHeight();
  const float left = em(kLeftPanelEm);
  const bool is_wide = screen.x > em(kLeftPanelEm + kRightPanelEm + kPictureEm);
  const float right = is_wide ? em(kRightPanelEm) : 0;
  draw_columns(top, left, right);
  picture_ = {static_cast<int>(left * pixels.x),
              static_cast<int>(top * pixels.y),
              {static_cast<int>((screen.x - left - right) * pixels.x),
               static_cast<int>((screen.y - top) * pixels.y)}};
  toasts_.lower_left = {left, screen.y};
  hud_.upper_right = {screen.x - right, top};
  hud_.shows_figures = is_wide;
  hud_.room = {screen.x - left - right, screen.y - top};
  if (!workspace_->document()) return;
  if (shows_hud_) hud_.draw(*workspace_);
  colour_bar_.lower_right = {screen.x - right, screen.y};
  colour_bar_.draw(*workspace_);
  draw_ruler_overlay(*workspace_, {left, top}, pixels);
  section_window_.draw(*workspace_);
}

void App::draw_start_page() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float top = ImGui::GetFrameHeight();
  const float width = std::min(screen.x, em(72));
  ImGui::SetNextWindowPos({0, top});
  ImGui::SetNextWindowSize({screen.x, screen.y - top});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {std::max(em(1.5f), (screen.x - width) / 2), em(0.5f)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::Begin("##start", nullptr, kFixed);
  ImGui::PopStyleVar(2);
  begin_place_group("Start");
  start_page_.draw(*workspace_);
  note_window("Start page");
  ImGui::End();
  toasts_.lower_left = {std::max(0.0f, (screen.x - width) / 2), screen.y};
}

/// Returns whether the section is open.
static bool draw_section(const char* name, Panel& panel, Workspace& workspace,
                         ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_DefaultOpen) {
  begin_place_group("");
  const ImVec2 low = ImGui::GetCursorScreenPos();
  if (!noted(name, ImGui::CollapsingHeader(name, flags))) return false;
  begin_place_group(name);
  ImGui::PushID(name);
  ImGui::PushTextWrapPos(0);  // at the column's edge
  panel.draw(workspace);
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, em(0.25f)});
  ImGui::PopID();
  const float bottom = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
  note_area(name, low, {low.x + ImGui::GetContentRegionAvail().x, bottom});
  return true;
}

static void begin_column(const char* name, float from, float top, float width) {
  ImGui::SetNextWindowPos({from, top});
  ImGui::SetNextWindowSize({width, ImGui::GetIO().DisplaySize.y - top});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::Begin(name, nullptr, kFixed);
  ImGui::PopStyleVar();
}

// If there is no room for a right column, all panels are in the left one, which scrolls.
void App::draw_columns(float top, float left, float right) {
  begin_column("##left", 0, top, left);
  if (workspace_->raw()) {
    draw_raw_facts(*workspace_);
    note_window("Left column");
    ImGui::End();
    if (right > 0) begin_column("##right", ImGui::GetIO().DisplaySize.x - right, top, right);
    if (right > 0) ImGui::End();
    return;
  }
  draw_section("Filter", filter_panel_, *workspace_);
  draw_section("Transfer curve α(κ)", curve_panel_, *workspace_);
  draw_section("Brush", brush_panel_, *workspace_);
  const bool shows_region = draw_section("Limits", protect_panel_, *workspace_);
  draw_section("Keep edges", edges_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  draw_section("Equaliser", equaliser_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  const bool shows_curves =
      draw_section("Palette", palette_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  workspace_->document()->show_over(shows_region, shows_curves);
  if (workspace_->document()->has_colours())
    draw_section("Colours", colour_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  if (right > 0) {
    note_window("Left column");
    ImGui::End();
    begin_column("##right", ImGui::GetIO().DisplaySize.x - right, top, right);
  }
  draw_section("View", view_panel_, *workspace_);
  draw_section("History", history_panel_, *workspace_);
  draw_section("People", people_panel_, *workspace_);
  draw_section("Numbers", numbers_panel_, *workspace_);
  draw_section("Light", light_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  draw_section("Camera", camera_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  if (right == 0 && shows_hud_) draw_section("Figures", figures_panel_, *workspace_);
  note_window(right > 0 ? "Right column" : "Left column");
  ImGui::End();
}

void App::draw_overlays() {
  draw_sides();
  draw_lasso();
  toasts_.draw(*workspace_);
  if (shows_log_) draw_message_log(workspace_->log, shows_log_);
  if (shows_help_) draw_key_help(bindings_, shows_help_);
  if (workspace_->document()) export_dialog_.draw(*workspace_);
  file_dialog_.draw(*workspace_);
  preferences_dialog_.draw(*workspace_);
  if (start_page_.take_open_wish()) ask_for_scan();
  if (auto wish = export_dialog_.take_question()) {
    file_dialog_.ask(std::move(*wish), workspace_->preferences,
                     [this](const std::filesystem::path& file) { export_dialog_.open(file); });
  }
  draw_leave_question(*workspace_, leave_step_, leaving_);
}

}  // namespace burnish
