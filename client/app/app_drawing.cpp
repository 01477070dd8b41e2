// The part of App that draws: the surface, the panels around it and the menus.

#include <algorithm>
#include <chrono>

#include "client/app/app.h"
#include "client/app/dialogs/about.h"
#include "client/app/dialogs/key_help.h"
#include "client/app/dialogs/leave_question.h"
#include "client/app/overlay/guides_overlay.h"
#include "client/app/overlay/ruler_overlay.h"
#include "client/app/panels/raw_facts.h"
#include "client/app/widgets/depth_list.h"
#include "client/app/widgets/drawn_panel.h"
#include "client/app/widgets/escape.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "client/app/widgets/words.h"
#include "client/model/documents/undo_words.h"
#include "client/model/view/position_text.h"
#include "client/report/depth_text.h"
#include "common/base/limits.h"

namespace burnish {

// ---- The picture ----

// Smooth edges take the processors twice the time, so they are for pictures at rest.
static constexpr std::chrono::milliseconds kRest{100};

Status App::draw() {
  const ImageSize size = window_->framebuffer_size();
  if (size.width < kImageSidePixelsMin || size.height < kImageSidePixelsMin) {
    workspace_->strip.close(workspace_->document());  // a window that is put away has no pictures
    return Status::ok();
  }
  window_->begin_frame();
  close_lists_at_escape();
  draw_panels();
  const auto now = std::chrono::steady_clock::now();
  const bool is_new = shows_surface() && !(is_idle_ && is_surface_at_rest());
  const Status drawn = is_new ? update_surface(now) : Status::ok();
  if (shows_surface() && is_surface_at_rest()) workspace_->keep_strength_picture();
  if (shows_surface()) save_picture_at_rest(now);
  const bool has_new_panels = window_->end_frame();
  if (std::exchange(is_surface_new_, false) || has_new_panels) show_picture();
  write_places();
  return drawn;
}

// The surface lies between the panels, if they leave room.
bool App::shows_surface() const {
  return workspace_->has_picture() && check_image_size(picture_.size).is_ok();
}

void App::show_picture() {
  clear_window();
  const int bottom = window_->framebuffer_size().height - picture_.y - picture_.size.height;
  if (shows_surface()) renderer_->show({picture_.x, bottom});
  window_->show_frame();
}

// Draws the surface again if its picture has changed.
Status App::update_surface(std::chrono::steady_clock::time_point now) {
  workspace_->viewport.set_size(picture_.size);
  RETURN_IF_ERROR(workspace_->look());
  Shown next = next_shown();
  if (!(next == shown_)) changed_at_ = now;
  next.is_smooth =
      !renderer_->has_rough_pictures() ||
      (next == shown_ && (shown_.is_smooth || (is_picture_fine() && now - changed_at_ >= kRest)));
  if (next == shown_ || keeps_raw_picture()) return Status::ok();
  shown_ = std::move(next);
  return draw_surface(now);
}

// Smooth as the last picture is.
App::Shown App::next_shown() const {
  const Document* const document = workspace_->document();
  Shown next{.surface = workspace_->pictures_begun(),
             .is_raw = document == nullptr,
             .size = picture_.size,
             .camera = workspace_->viewport.camera,
             .is_smooth = shown_.is_smooth};
  if (document) {
    next.changes = document->picture_changes();
    next.style = workspace_->viewport.style(*document);
  }
  return next;
}

Status App::draw_surface(std::chrono::steady_clock::time_point begun_at) {
  renderer_->set_smooth(shown_.is_smooth);
  RETURN_IF_ERROR(workspace_->draw());
  RETURN_IF_ERROR(renderer_->take_picture());
  is_surface_new_ = true;
  // One of the background alone takes no time, and must not hold the surface up.
  const Document* const document = workspace_->document();
  const bool has_surface = document && !document->surface().patches().empty();
  if (!has_surface || is_slower_than_moving()) return Status::ok();
  begun_at_ = begun_at;
  drawn_.put();
  return Status::ok();
}

// Such a picture says nothing about how many triangles a moving one may have.
bool App::is_slower_than_moving() const {
  return renderer_->has_rough_pictures() && shown_.is_smooth;
}

// Whether all is drawn, as far as it is here.
bool App::is_surface_at_rest() const {
  return is_picture_fine() && (!shows_surface() || (shown_.is_smooth && next_shown() == shown_));
}

// The raw scan's picture stays until that of its session is as fine, or the user turns it.
bool App::keeps_raw_picture() const {
  return shown_.is_raw && picture_.size == shown_.size &&
         workspace_->keeps_raw_picture(shown_.camera);
}

// Says that the picture is not of the session's values.
void App::draw_trial() const {
  const std::string text = workspace_->strip.trial_text();
  if (text.empty()) return;
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  const float x = static_cast<float>(picture_.x) + static_cast<float>(picture_.size.width) / 2;
  const float top = static_cast<float>(picture_.y) / pixels.y + em(0.6f);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetBackgroundDrawList()->AddText({x / pixels.x - width / 2, top},
                                          ImGui::ColorConvertFloat4ToU32(theme::kOnPicture),
                                          text.c_str());
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
  const ImU32 dark = ImGui::ColorConvertFloat4ToU32(theme::kOnPicture);
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

// ---- The panels ----

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
  workspace_->viewport.pixel_ratio = em(1) * pixels.x / kEmPixels;
  draw_scale_bar_overlay(*workspace_, {screen.x - right, colour_bar_.top}, pixels);
  draw_axes_overlay(*workspace_, {left, top}, pixels);
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

static bool draw_section(const SharedPanel& shared, Workspace& workspace,
                         ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_DefaultOpen) {
  DrawnPanel panel(shared);
  return draw_section(shared.name, panel, workspace, flags);
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
  const bool shows_filter = draw_section("Filter", filter_panel_, *workspace_);
  if (!shows_filter) workspace_->strip.close(workspace_->document());
  draw_section("Transfer curve α(κ)", curve_panel_, *workspace_);
  draw_section(kBrushPanel, *workspace_);
  const bool shows_region = draw_section(kLimitsPanel, *workspace_);
  draw_section(kEdgesPanel, *workspace_, ImGuiTreeNodeFlags_None);
  draw_section("Equaliser", equaliser_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  const bool shows_curves =
      draw_section("Palette", palette_panel_, *workspace_, ImGuiTreeNodeFlags_None);
  workspace_->document()->show_over(shows_region, shows_curves);
  if (workspace_->document()->has_colours())
    draw_section(kColourPanel, *workspace_, ImGuiTreeNodeFlags_None);
  if (right > 0) {
    note_window("Left column");
    ImGui::End();
    begin_column("##right", ImGui::GetIO().DisplaySize.x - right, top, right);
  }
  draw_section(kViewPanel, *workspace_);
  draw_section("History", history_panel_, *workspace_);
  draw_section("People", people_panel_, *workspace_);
  draw_section("Numbers", numbers_panel_, *workspace_);
  draw_section(kLightPanel, *workspace_, ImGuiTreeNodeFlags_None);
  draw_section(kCameraPanel, *workspace_, ImGuiTreeNodeFlags_None);
  if (right == 0 && shows_hud_) draw_section("Figures", figures_panel_, *workspace_);
  note_window(right > 0 ? "Right column" : "Left column");
  ImGui::End();
}

void App::draw_overlays() {
  draw_sides();
  draw_trial();
  draw_lasso();
  draw_picture_menu();
  toasts_.draw(*workspace_);
  if (shows_log_) draw_message_log(workspace_->log, shows_log_);
  if (shows_help_) draw_key_help(bindings_, shows_help_);
  if (shows_about_) draw_about(shows_about_);
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

// ---- The menus ----

/// `what`: stands behind the name.
void App::menu_item(const char* name, Action action, bool enabled, const std::string& what) {
  const std::string label = what.empty() ? name : name + (": " + what + "###") + name;
  const std::string keys = bindings_.keys_of(action);
  if (noted(name, ImGui::MenuItem(label.c_str(), keys.c_str(), false, enabled))) do_action(action);
}

void App::draw_undo_items() {
  const Document& document = *workspace_->document();
  menu_item("Undo", Action::kUndo, !document.is_viewer(), undo_name(document));
  menu_item("Redo", Action::kRedo, !document.is_viewer(), document.undo_steps().redo_name());
}

// A click of the right button has asked for it. The page has its items in picture_menu.tsx.
void App::draw_picture_menu() {
  constexpr const char* kId = "##picture menu";
  std::optional<PictureMenu>& menu = workspace_->viewport.menu;
  if (menu && !std::exchange(has_picture_menu_, true)) ImGui::OpenPopup(kId);
  if (!ImGui::BeginPopup(kId)) {
    if (std::exchange(has_picture_menu_, false)) menu.reset();
    return;
  }
  begin_place_group("Picture menu");
  const Document* const document = workspace_->document();
  const std::optional<Vec3d> point = menu ? menu->point : std::nullopt;
  menu_item("Look at this point", Action::kFocus, point.has_value());
  menu_item("Frame all", Action::kFrameAll);
  draw_camera_menu();
  ImGui::Separator();
  if (noted("Copy position", ImGui::MenuItem("Copy position", nullptr, false, point.has_value()))) {
    const std::string position = position_text(*point, document->diagonal());
    ImGui::SetClipboardText(position.c_str());
    workspace_->log.info("copied " + position);
  }
  ImGui::Separator();
  if (document) draw_undo_items();
  ImGui::Separator();
  menu_item("Save picture", Action::kScreenshot);
  note_window("Picture menu");
  ImGui::EndPopup();
}

void App::draw_menu_bar() {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  const bool is_drawn = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!is_drawn) return;
  begin_place_group("Menu");
  Workspace& workspace = *workspace_;
  const bool is_open = workspace.document() != nullptr;
  if (noted("File", ImGui::BeginMenu("File"))) {
    menu_item("Open…", Action::kOpen);
    ImGui::Separator();
    menu_item("Export…", Action::kExport, is_open);
    menu_item("Save picture", Action::kScreenshot, is_open);
    if (ImGui::MenuItem("Save picture as…", nullptr, false, is_open)) ask_for_picture();
    ImGui::Separator();
    if (noted("Close session", ImGui::MenuItem("Close session", nullptr, false, is_open)))
      leaving_.begin(Leaving::What::kSession, std::chrono::steady_clock::now());
    draw_depth_menu();
    ImGui::Separator();
    if (noted("Preferences", ImGui::MenuItem("Preferences…"))) preferences_dialog_.open();
    menu_item("Quit", Action::kQuit);
    ImGui::EndMenu();
  }
  if (noted("Edit", ImGui::BeginMenu("Edit", workspace.document() != nullptr))) {
    draw_undo_items();
    ImGui::EndMenu();
  }
  if (noted("View", ImGui::BeginMenu("View"))) {
    menu_item("Frame all", Action::kFrameAll, workspace.document() != nullptr);
    menu_item("Wireframe", Action::kWireframe, workspace.document() != nullptr);
    menu_item("Split", Action::kSplit, workspace.document() != nullptr);
    noted("Figures", ImGui::MenuItem("Figures", nullptr, &shows_hud_));
    menu_item("Messages", Action::kLog);
    draw_camera_menu();
    ImGui::EndMenu();
  }
  if (noted("Help", ImGui::BeginMenu("Help"))) {
    menu_item("Keys", Action::kHelp);
    if (noted("About", ImGui::MenuItem("About and manual"))) shows_about_ = true;
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
