// The part of App that does what keys and menus ask for.

#include <chrono>
#include <ctime>

#include "client/app/app.h"
#include "client/app/widgets/words.h"
#include "client/model/workspace/document_actions.h"
#include "client/scene/png_writer.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

static constexpr std::chrono::seconds kPicturePatience{10};

static std::string picture_name() {
  char name[64];
  const time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::strftime(name, sizeof name, "burnish-%F-%H%M%S.png", &local);
  return name;
}

void App::handle_key(const std::string& key) {
  const auto action = bindings_.action_of(key);
  if (leave_step_ == Leaving::Step::kAsk || leave_step_ == Leaving::Step::kWait) {
    if (action == Action::kCancel) leaving_.stay();
    return;
  }
  const bool is_asked = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (action && !is_asked) do_action(*action);
}

void App::do_action(Action action) {
  if (action == Action::kOpen) return ask_for_scan();
  if (action == Action::kHelp) shows_help_ = !shows_help_;
  if (action == Action::kLog) shows_log_ = !shows_log_;
  if (action == Action::kCancel) {
    const bool was_busy =
        workspace_->document() && workspace_->viewport.cancel(*workspace_->document());
    if (!was_busy) shows_help_ = shows_log_ = false;
  }
  if (workspace_->raw() && action == Action::kFrameAll) workspace_->viewport.go_home();
  if (!workspace_->document()) return;
  if (action == Action::kExport) export_dialog_.open();
  if (action == Action::kScreenshot) return take_screenshot(picture_name());
  do_document_action(action, *workspace_);
}

void App::ask_for_scan() {
  file_dialog_.ask({.title = "Open a scan", .extensions = mesh_extensions()},
                   workspace_->preferences,
                   [this](const std::filesystem::path& file) { open_files({file}); });
}

// Opens the first file instead of the open session. The others are imported only.
void App::open_files(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    const bool replaces = workspace_->document() && open_next_.empty() && &file == &files.front();
    if (!replaces) {
      workspace_->import_scan(file);
      continue;
    }
    open_next_ = file;
    leaving_.begin(Leaving::What::kSession, std::chrono::steady_clock::now());
  }
}

void App::ask_for_picture() {
  file_dialog_.ask({.purpose = FileQuestion::Purpose::kSave,
                    .title = "Save a picture",
                    .extensions = {".png"},
                    .start = picture_name()},
                   workspace_->preferences,
                   [this](const std::filesystem::path& file) { take_screenshot(file); });
}

void App::take_screenshot(const std::filesystem::path& file) {
  workspace_->record_picture(file);
  wanted_picture_ = WantedPicture{file, std::chrono::steady_clock::now() + kPicturePatience};
}

// Rings of brushes are no part of the surface. The window's own picture has them again at once.
Result<Image> App::picture_without_rings() {
  PageRenderer& pages = renderer_->pages();
  const Document* const document = workspace_->document();
  if (!document) return pages.read_pixels();
  DrawStyle style = shown_.style;
  style.rings.clear();
  renderer_->set_smooth(true);
  const Viewport& viewport = workspace_->viewport;
  RETURN_IF_ERROR(
      pages.draw(viewport.camera, viewport.size(), style, document->surface().patches()));
  Result<Image> picture = pages.read_pixels();
  renderer_->set_smooth(shown_.is_smooth);
  RETURN_IF_ERROR(workspace_->draw());
  return picture;
}

void App::save_picture_at_rest(std::chrono::steady_clock::time_point now) {
  if (!wanted_picture_ || (!is_surface_at_rest() && now < wanted_picture_->until)) return;
  const std::filesystem::path file = std::exchange(wanted_picture_, std::nullopt)->file;
  const Result<Image> picture = picture_without_rings();
  const Status written = picture.is_ok() ? write_png(*picture, file) : picture.status();
  if (!written.is_ok()) return workspace_->log.failure("screenshot", written);
  std::error_code ignored;
  const std::string saved = "saved " + std::filesystem::absolute(file, ignored).string();
  const Document* const document = workspace_->document();
  const std::string lack = document ? simplified_text(document->surface().status()) : "";
  if (lack.empty()) return workspace_->log.info(saved);
  workspace_->log.warning(saved + ": " + lack);
}

}  // namespace burnish
