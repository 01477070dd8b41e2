#include <algorithm>

#include "client/app/app.h"
#include "client/app/key_help.h"
#include "client/app/leave_question.h"
#include "client/app/theme.h"

namespace burnish {

static constexpr ImGuiWindowFlags kFixed =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

Status App::draw() {
  const ImageSize size = window_->framebuffer_size();
  if (size.width < kImageSidePixelsMin || size.height < kImageSidePixelsMin) return Status::ok();
  window_->begin_frame();
  draw_panels();
  renderer_->clear_window();
  const Status drawn = workspace_->document() ? draw_picture() : Status::ok();
  window_->end_frame();
  return drawn;
}

// Draws the picture between the panels, if they leave room.
Status App::draw_picture() {
  if (!check_image_size(picture_.size).is_ok()) return Status::ok();
  Workspace& workspace = *workspace_;
  workspace.viewport.set_size(picture_.size);
  RETURN_IF_ERROR(workspace.look());
  const Document& document = *workspace.document();
  Shown now{workspace.documents_opened(), document.picture_changes(), picture_.size,
            workspace.viewport.camera, workspace.viewport.style(document)};
  if (!(now == shown_)) RETURN_IF_ERROR(workspace.viewport.draw(*renderer_, document));
  shown_ = std::move(now);
  const int bottom = window_->framebuffer_size().height - picture_.y - picture_.size.height;
  renderer_->show({picture_.x, bottom});
  return Status::ok();
}

void App::draw_panels() {
  draw_menu_bar();
  if (!workspace_->document()) {
    picture_ = {};
    draw_start_page();
  } else {
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
    hud_.upper_right = {screen.x - right, top};
    toasts_.lower_left = {left, screen.y};
    hud_.shows_figures = is_wide;
    if (shows_hud_) hud_.draw(*workspace_);
  }
  draw_overlays();
}

void App::draw_menu_bar() {
  if (!ImGui::BeginMainMenuBar()) return;
  Workspace& workspace = *workspace_;
  const bool is_open = workspace.document() != nullptr;
  const auto item = [&](const char* label, Action action, bool enabled = true) {
    if (ImGui::MenuItem(label, bindings_.key_of(action).c_str(), false, enabled)) do_action(action);
  };
  if (ImGui::BeginMenu("File")) {
    item("Export…", Action::kExport, is_open);
    item("Save picture", Action::kScreenshot, is_open);
    if (ImGui::MenuItem("Close session", nullptr, false, is_open))
      leaving_.begin(Leaving::What::kSession, std::chrono::steady_clock::now());
    ImGui::Separator();
    if (ImGui::MenuItem("Quit")) window_->close();
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Edit", workspace.document() != nullptr)) {
    item("Undo", Action::kUndo);
    item("Redo", Action::kRedo);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    item("Frame all", Action::kFrameAll, workspace.document() != nullptr);
    item("Wireframe", Action::kWireframe, workspace.document() != nullptr);
    item("Split", Action::kSplit, workspace.document() != nullptr);
    ImGui::MenuItem("Figures", nullptr, &shows_hud_);
    item("Messages", Action::kLog);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Help")) {
    item("Keys", Action::kHelp);
    ImGui::EndMenu();
  }
  if (Document* const document = workspace.document()) {
    const std::string title = document->scan().scan.name + " · " + document->session().name;
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - em(1.6f));
    faint_text("%s", title.c_str());
  }
  ImGui::EndMainMenuBar();
}

void App::draw_start_page() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float top = ImGui::GetFrameHeight();
  const float width = std::min(screen.x, em(72));
  ImGui::SetNextWindowPos({0, top});
  ImGui::SetNextWindowSize({screen.x, screen.y - top});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {std::max(em(1.5f), (screen.x - width) / 2), em(0.5f)});
  ImGui::Begin("##start", nullptr, kFixed);
  ImGui::PopStyleVar();
  start_page_.draw(*workspace_);
  ImGui::End();
  toasts_.lower_left = {0, screen.y};
}

static void draw_section(const char* name, Panel& panel, Workspace& workspace) {
  if (!ImGui::CollapsingHeader(name, ImGuiTreeNodeFlags_DefaultOpen)) return;
  ImGui::PushID(name);
  panel.draw(workspace);
  ImGui::Dummy({0, em(0.25f)});
  ImGui::PopID();
}

static void begin_column(const char* name, float from, float top, float width) {
  ImGui::SetNextWindowPos({from, top});
  ImGui::SetNextWindowSize({width, ImGui::GetIO().DisplaySize.y - top});
  ImGui::Begin(name, nullptr, kFixed);
}

// If there is no room for a right column, all panels are in the left one, which scrolls.
void App::draw_columns(float top, float left, float right) {
  begin_column("##left", 0, top, left);
  draw_section("Filter", filter_panel_, *workspace_);
  draw_section("Transfer curve α(κ)", curve_panel_, *workspace_);
  draw_section("Brush", brush_panel_, *workspace_);
  draw_section("Limits", protect_panel_, *workspace_);
  if (right > 0) {
    ImGui::End();
    begin_column("##right", ImGui::GetIO().DisplaySize.x - right, top, right);
  }
  draw_section("View", view_panel_, *workspace_);
  draw_section("History", history_panel_, *workspace_);
  draw_section("People", people_panel_, *workspace_);
  if (right == 0 && shows_hud_) draw_section("Figures", figures_panel_, *workspace_);
  ImGui::End();
}

// Says which surface is the original one, and draws the line between both.
void App::draw_sides() const {
  const ViewOptions& view = workspace_->viewport.options;
  const bool is_original = workspace_->viewport.hold_original;
  if (!(view.split || is_original) || !workspace_->document()) return;
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  const int middle = split_column(is_original ? 0.5 : view.split_at, picture_.size.width);
  const float x = static_cast<float>(picture_.x + middle) / pixels.x;
  const float top = static_cast<float>(picture_.y) / pixels.y;
  const float bottom = static_cast<float>(picture_.y + picture_.size.height) / pixels.y;
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  const ImU32 dark = ImGui::ColorConvertFloat4ToU32(theme::kPanel);
  const float pad = em(0.6f), width = ImGui::CalcTextSize("original").x;
  const float line = bottom - ImGui::GetTextLineHeight() - pad;
  if (is_original) return list->AddText({x - width / 2, line}, dark, "original");
  list->AddLine({x, top}, {x, bottom}, dark, em(0.1f));
  list->AddText({x - width - pad, line}, dark, "original");
  list->AddText({x + pad, line}, dark, "edited");
}

void App::draw_lasso() const {
  const std::vector<Eigen::Vector2d>& pixels = workspace_->viewport.lasso();
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  std::vector<ImVec2> line;
  for (const Eigen::Vector2d& pixel : pixels)
    line.emplace_back((picture_.x + float(pixel.x())) / scale.x,
                      (picture_.y + float(pixel.y())) / scale.y);
  ImGui::GetBackgroundDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()),
                                              ImGui::ColorConvertFloat4ToU32(theme::kBusy),
                                              ImDrawFlags_Closed, em(0.12f));
}

void App::draw_overlays() {
  draw_sides();
  draw_lasso();
  toasts_.draw(*workspace_);
  if (shows_log_) draw_message_log(workspace_->log, shows_log_);
  if (shows_help_) draw_key_help(bindings_, shows_help_);
  if (workspace_->document()) export_dialog_.draw(*workspace_);
  draw_leave_question(*workspace_, leave_step_, leaving_);
}

}  // namespace burnish
