#include "client/app/app.h"

#include <chrono>
#include <csignal>
#include <ctime>

#include "client/app/widgets/places.h"
#include "client/gl/capabilities.h"
#include "client/model/workspace/document_actions.h"
#include "client/scene/png_writer.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

// ImGui needs a second picture to show the effect of a click.
static constexpr int kPicturesAfterEvent = 3;
static constexpr double kIdleSeconds = 0.5;
static constexpr double kFinerSeconds = 0.016;    // while the picture becomes finer
static constexpr double kDrawingSeconds = 0.004;  // while the card draws

static volatile std::sig_atomic_t ended_by_signal = 0;

Status App::run(AppOptions options, Preferences preferences) {
  // Ends in order: unsaved edits are saved or reported.
  for (int number : {SIGINT, SIGTERM, SIGHUP})
    std::signal(number, [](int) { ended_by_signal = 1; });
  Bindings bindings;
  for (const auto& [action, key] : preferences.keys) RETURN_IF_ERROR(bindings.bind(action, key));
  App app(std::move(options), std::move(bindings));
  RETURN_IF_ERROR(app.start(std::move(preferences)));
  const Status status = app.loop();
  const ImageSize size = app.window_->size();
  app.window_->hide();  // running calls may still wait for their server
  if (size.width > 0) {
    app.workspace_->preferences.window_width = size.width;
    app.workspace_->preferences.window_height = size.height;
  }
  app.workspace_->keep_session_picture();
  app.workspace_->save_preferences();
  app.workspace_.reset();  // before the window: the workspace's threads wake the window
  app.renderer_.reset();
  return status;
}

// Leaves half of the card's free memory to others.
static PageBudget budget_of(const Capabilities& card, uint64_t triangles_max) {
  PageBudget budget = card.is_software ? processor_budget() : PageBudget();
  if (triangles_max > 0) budget.triangles = triangles_max;
  if (card.free_bytes > 0) budget.card_bytes = std::min(budget.card_bytes, card.free_bytes / 2);
  return budget;
}

Status App::start(Preferences preferences) {
  ImageSize size = options_.size;
  if (size.width == 0) size = {preferences.window_width, preferences.window_height};
  scale_at_start_ = preferences.scale;
  ASSIGN_OR_RETURN(window_, Window::create(size, look_of(preferences), make_events()));
  const Capabilities card = card_capabilities();
  ASSIGN_OR_RETURN(renderer_, WindowRenderer::create(card));
  options_.workspace.shows_raw = true;
  options_.workspace.budget = budget_of(card, options_.triangles_max);
  options_.workspace.wake = [this] {
    news_ = true;
    Window::wake();
  };
  workspace_ =
      std::make_unique<Workspace>(renderer_->pages(), std::move(preferences), options_.workspace);
  if (!options_.record.empty()) RETURN_IF_ERROR(workspace_->recorder.open(options_.record));
  const std::string lack = Pen::lack();
  if (!lack.empty()) workspace_->log.info("a pen's pressure does not count: " + lack);
  if (!options_.places.empty()) follow_places(options_.places);
  open_what_was_asked();
  return Status::ok();
}

void App::open_what_was_asked() {
  Workspace& workspace = *workspace_;
  if (!options_.server.empty()) workspace.connect(options_.server);
  if (!options_.scan.empty()) {
    workspace.import_scan(options_.scan);
  } else if (!options_.session.empty()) {
    workspace.when_connected([this] { workspace_->join_by_name(options_.session); });
  }
}

Status App::loop() {
  int pictures = kPicturesAfterEvent;
  for (;;) {
    window_->wait(seconds_to_wait(pictures));
    const bool has_news = window_->take_dirty() || news_.exchange(false);
    is_idle_ = !has_news && pictures <= 0;
    pictures = has_news ? kPicturesAfterEvent : std::max(pictures, 1);
    const bool draws = may_draw();
    if (draws) window_->deliver();
    workspace_->update(draws);
    if (may_close()) break;
    if (!draws) continue;
    show_title();
    show_look();
    RETURN_IF_ERROR(draw());
    --pictures;
  }
  if (leave_step_ == Leaving::Step::kLeave) return Status::ok();
  return failed_precondition(text_of(workspace_->unsaved()) + " and will be lost");
}

double App::seconds_to_wait(int pictures) {
  if (!may_draw()) return kDrawingSeconds;
  if (pictures > 0) return 0;
  return is_surface_at_rest() ? kIdleSeconds : kFinerSeconds;
}

// A picture begins when the card has drawn the last one, so that none waits behind others.
bool App::may_draw() {
  if (!begun_at_) return true;
  if (!drawn_.is_reached()) return false;
  const auto took = std::chrono::steady_clock::now() - *std::exchange(begun_at_, std::nullopt);
  workspace_->on_picture(std::chrono::duration<double, std::milli>(took).count(),
                         renderer_->surface_ms());
  return true;
}

// A session is named once its own surface is on the screen.
std::string App::title() const {
  if (const RawScan* const raw = workspace_->raw()) return raw->name;
  const Document* const document = workspace_->document();
  if (!document) return {};
  const std::string scan = document->scan().scan.name;
  return keeps_raw_picture() ? scan : scan + " · " + document->session().name;
}

void App::show_title() {
  const std::string what = title();
  const std::string shown = what.empty() ? "Burnish" : what + " – Burnish";
  if (std::exchange(title_, shown) != shown) window_->set_title(shown);
}

// --scale counts until the user chooses another size.
WindowLook App::look_of(const Preferences& preferences) const {
  const bool is_given = options_.scale > 0 && preferences.scale == scale_at_start_;
  return {is_given ? options_.scale : preferences.scale, preferences.light_theme, letters_.all()};
}

// Loads letters as soon as a text has them.
void App::show_look() {
  add_letters(*workspace_, letters_);
  file_dialog_.add_letters(letters_);
  const std::string missing = window_->set_look(look_of(workspace_->preferences));
  if (missing.empty() || std::exchange(missing_letters_, missing) == missing) return;
  workspace_->log.warning(
      "no font here has some letters of this script; they are drawn as boxes: " + missing);
}

bool App::is_picture_fine() const {
  const Document* const document = workspace_->document();
  return document == nullptr || document->is_picture_fine();
}

bool App::may_close() {
  using Step = Leaving::Step;
  const auto now = std::chrono::steady_clock::now();
  if (window_->take_close_request() || ended_by_signal) leaving_.begin(Leaving::What::kWindow, now);
  leave_step_ = leaving_.update(workspace_->unsaved(), workspace_->link() == LinkState::kLive, now);
  if (ended_by_signal) return leave_step_ != Step::kSave;  // nobody can answer a question
  if (leave_step_ == Step::kStay) open_next_.clear();
  if (leave_step_ != Step::kLeave) return false;
  if (leaving_.what() == Leaving::What::kWindow) return true;
  leaving_.stay();
  workspace_->close_document();
  if (!open_next_.empty()) workspace_->import_scan(std::exchange(open_next_, {}));
  return false;
}

// ---- The window's events ----

WindowEvents App::make_events() {
  WindowEvents events;
  events.press = [this](PointerButton button, Modifiers modifiers, const Eigen::Vector2d& pixel) {
    if (workspace_ && workspace_->has_picture() && is_in_picture(pixel))
      workspace_->viewport.press(button, modifiers, in_picture(pixel));
  };
  events.pen = [this](std::optional<double> pressure) {
    if (workspace_) take_pen(pressure);
  };
  events.release = [this](PointerButton button) {
    if (workspace_) workspace_->viewport.release(button);
  };
  events.move = [this](const Eigen::Vector2d& pixel) {
    if (!workspace_ || !workspace_->has_picture()) return;
    if (is_in_picture(pixel) || workspace_->viewport.is_busy()) {
      workspace_->viewport.move(in_picture(pixel));
    } else {
      workspace_->viewport.leave();
    }
  };
  events.wheel = [this](const Eigen::Vector2d& pixel, double steps) {
    if (workspace_ && workspace_->has_picture() && is_in_picture(pixel))
      workspace_->viewport.wheel(in_picture(pixel), steps);
  };
  events.key = [this](const std::string& key) {
    if (workspace_) handle_key(key);
  };
  events.space = [this](bool held) {
    if (workspace_) workspace_->viewport.hold_original = held;
  };
  events.drop = [this](const std::vector<std::filesystem::path>& files) {
    if (workspace_) open_files(files);
  };
  return events;
}

void App::take_pen(std::optional<double> pressure) {
  workspace_->has_pen |= pressure.has_value();
  const bool counts = workspace_->preferences.pen_pressure;
  workspace_->viewport.pressure = counts ? pressure.value_or(1) : 1;
}

static bool lies_within(const Eigen::Vector2d& pixel, const ImVec2& low, const ImVec2& high) {
  return pixel.x() >= low.x && pixel.x() < high.x && pixel.y() >= low.y && pixel.y() < high.y;
}

bool App::is_in_picture(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d at = in_picture(pixel);
  if (at.x() < 0 || at.y() < 0 || at.x() >= picture_.size.width || at.y() >= picture_.size.height)
    return false;
  if (shows_help_ || shows_about_ || shows_log_ || export_dialog_.is_open() ||
      file_dialog_.is_open())
    return false;
  constexpr auto kAnyPopup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  if (ImGui::IsPopupOpen("", kAnyPopup)) return false;  // a click beside the popup closes it
  return !lies_within(pixel, toasts_.covered_low, toasts_.covered_high) &&
         !lies_within(pixel, section_window_.covered_low, section_window_.covered_high);
}

Eigen::Vector2d App::in_picture(const Eigen::Vector2d& pixel) const {
  return pixel - Eigen::Vector2d(picture_.x, picture_.y);
}

// ---- What keys and menus ask for ----

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
  if (action == Action::kQuit) return window_->close();
  if (action == Action::kLog) shows_log_ = !shows_log_;
  if (action == Action::kCancel) {
    const bool was_busy =
        workspace_->document() && workspace_->viewport.cancel(*workspace_->document());
    if (!was_busy) shows_help_ = shows_about_ = shows_log_ = false;
  }
  if (workspace_->raw() && action == Action::kFrameAll) workspace_->viewport.go_home();
  if (!workspace_->document()) return;
  if (action == Action::kExport) export_dialog_.open();
  if (action == Action::kSave) return workspace_->tell_saved();
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
  if (!document) return workspace_->read_picture({});
  DrawStyle style = shown_.style;
  style.rings.clear();
  renderer_->set_smooth(true);
  const Viewport& viewport = workspace_->viewport;
  RETURN_IF_ERROR(
      pages.draw(viewport.camera, viewport.size(), style, document->surface().patches()));
  Result<Image> picture = workspace_->read_picture(viewport.scale_bar());
  renderer_->set_smooth(shown_.is_smooth);
  RETURN_IF_ERROR(workspace_->draw());
  return picture;
}

void App::save_picture_at_rest(std::chrono::steady_clock::time_point now) {
  if (!wanted_picture_) return;
  workspace_->want_picture();
  const bool is_ready = is_surface_at_rest() && workspace_->check_picture().is_ok();
  if (!is_ready && now < wanted_picture_->until) return;
  const std::filesystem::path file = std::exchange(wanted_picture_, std::nullopt)->file;
  const Status checked = workspace_->check_picture();
  const Result<Image> picture = checked.is_ok() ? picture_without_rings() : checked;
  const Status written = picture.is_ok() ? write_png(*picture, file) : picture.status();
  if (!written.is_ok()) return workspace_->log.failure("screenshot", written);
  std::error_code ignored;
  const std::string saved = "saved " + std::filesystem::absolute(file, ignored).string();
  if (picture->note.empty()) return workspace_->log.info(saved);
  workspace_->log.warning(saved + ": " + picture->note);
}

}  // namespace burnish
