#include "client/app/app.h"

#include <chrono>
#include <csignal>
#include <ctime>

#include "client/gl/capabilities.h"
#include "client/model/document_actions.h"
#include "client/scene/png_writer.h"

namespace burnish {

// ImGui needs a second picture to show the effect of a click.
static constexpr int kPicturesAfterEvent = 3;
static constexpr double kIdleSeconds = 0.5;
static constexpr double kFinerSeconds = 0.016;  // while the picture becomes finer

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
  app.workspace_->save_preferences();
  app.workspace_.reset();  // before the window: the workspace's threads wake the window
  app.renderer_.reset();
  return status;
}

// Leaves half of the card's free memory to others.
static PageBudget budget_of(const Capabilities& card, uint64_t triangles_max) {
  PageBudget budget = card.is_software ? software_budget() : PageBudget();
  if (triangles_max > 0) budget.triangles = triangles_max;
  if (card.free_bytes > 0) budget.card_bytes = std::min(budget.card_bytes, card.free_bytes / 2);
  return budget;
}

Status App::start(Preferences preferences) {
  ImageSize size = options_.size;
  if (size.width == 0) size = {preferences.window_width, preferences.window_height};
  const double scale = options_.scale > 0 ? options_.scale : preferences.scale;
  ASSIGN_OR_RETURN(window_, Window::create(size, scale, make_events()));
  ASSIGN_OR_RETURN(renderer_, GlPageRenderer::create());
  const Capabilities card = card_capabilities();
  options_.workspace.is_software = card.is_software;
  options_.workspace.budget = budget_of(card, options_.triangles_max);
  options_.workspace.wake = [this] {
    news_ = true;
    Window::wake();
  };
  workspace_ = std::make_unique<Workspace>(*renderer_, std::move(preferences), options_.workspace);
  if (!options_.record.empty()) RETURN_IF_ERROR(workspace_->recorder.open(options_.record));
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
    window_->wait(pictures > 0 ? 0 : is_picture_settled() ? kIdleSeconds : kFinerSeconds);
    const bool timed_out = !window_->take_dirty() && !news_.exchange(false);
    pictures = timed_out ? std::max(pictures, 1) : kPicturesAfterEvent;
    window_->deliver();
    workspace_->update();
    if (may_close()) break;
    show_title();
    RETURN_IF_ERROR(draw());
    --pictures;
  }
  if (leave_step_ == Leaving::Step::kLeave) return Status::ok();
  return failed_precondition(unsaved_text(workspace_->unsaved_edits()) + " and will be lost");
}

void App::show_title() {
  const Document* const document = workspace_->document();
  std::string title = "Burnish";
  if (document)
    title = document->scan().scan.name + " · " + document->session().name + " – Burnish";
  if (std::exchange(title_, title) != title) window_->set_title(title);
}

bool App::is_picture_settled() const {
  const Document* const document = workspace_->document();
  return document == nullptr || document->is_picture_settled();
}

bool App::may_close() {
  using Step = Leaving::Step;
  const auto now = std::chrono::steady_clock::now();
  if (window_->take_close_request() || ended_by_signal) leaving_.begin(Leaving::What::kWindow, now);
  leave_step_ =
      leaving_.update(workspace_->unsaved_edits(), workspace_->link() == LinkState::kLive, now);
  if (ended_by_signal) return leave_step_ != Step::kSave;  // nobody can answer a question
  if (leave_step_ != Step::kLeave) return false;
  if (leaving_.what() == Leaving::What::kWindow) return true;
  leaving_.stay();
  workspace_->close_document();
  return false;
}

WindowEvents App::make_events() {
  WindowEvents events;
  events.press = [this](PointerButton button, Modifiers modifiers, const Eigen::Vector2d& pixel) {
    if (workspace_ && workspace_->document() && is_in_picture(pixel))
      workspace_->viewport.press(button, modifiers, in_picture(pixel));
  };
  events.release = [this](PointerButton button) {
    if (workspace_) workspace_->viewport.release(button);
  };
  events.move = [this](const Eigen::Vector2d& pixel) {
    if (!workspace_ || !workspace_->document()) return;
    if (is_in_picture(pixel) || workspace_->viewport.is_busy()) {
      workspace_->viewport.move(in_picture(pixel));
    } else {
      workspace_->viewport.leave();
    }
  };
  events.wheel = [this](const Eigen::Vector2d& pixel, double steps) {
    if (workspace_ && workspace_->document() && is_in_picture(pixel))
      workspace_->viewport.wheel(in_picture(pixel), steps);
  };
  events.key = [this](const std::string& key) {
    if (workspace_) handle_key(key);
  };
  events.space = [this](bool held) {
    if (workspace_) workspace_->viewport.hold_original = held;
  };
  events.drop = [this](const std::vector<std::filesystem::path>& files) {
    if (!workspace_) return;
    for (const auto& file : files) workspace_->import_scan(file);
  };
  return events;
}

bool App::is_in_picture(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d at = in_picture(pixel);
  if (at.x() < 0 || at.y() < 0 || at.x() >= picture_.size.width || at.y() >= picture_.size.height)
    return false;
  if (shows_help_ || shows_log_ || export_dialog_.is_open()) return false;
  constexpr auto kAnyPopup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  if (ImGui::IsPopupOpen("", kAnyPopup)) return false;  // a click beside the popup closes it
  return pixel.x() < toasts_.covered_low.x || pixel.x() >= toasts_.covered_high.x ||
         pixel.y() < toasts_.covered_low.y || pixel.y() >= toasts_.covered_high.y;
}

Eigen::Vector2d App::in_picture(const Eigen::Vector2d& pixel) const {
  return pixel - Eigen::Vector2d(picture_.x, picture_.y);
}

void App::handle_key(const std::string& key) {
  const auto action = bindings_.action_of(key);
  if (leave_step_ == Leaving::Step::kAsk || leave_step_ == Leaving::Step::kWait) {
    if (action == Action::kCancel) leaving_.stay();
    return;
  }
  if (action) do_action(*action);
}

void App::do_action(Action action) {
  if (action == Action::kHelp) shows_help_ = !shows_help_;
  if (action == Action::kLog) shows_log_ = !shows_log_;
  if (action == Action::kCancel) {
    const bool was_busy =
        workspace_->document() && workspace_->viewport.cancel(*workspace_->document());
    if (!was_busy) shows_help_ = shows_log_ = false;
  }
  if (!workspace_->document()) return;
  if (action == Action::kExport) export_dialog_.open();
  if (action == Action::kScreenshot) return take_screenshot();
  do_document_action(action, *workspace_);
}

void App::take_screenshot() {
  char name[64];
  const time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::strftime(name, sizeof name, "burnish-%F-%H%M%S.png", &local);
  workspace_->recorder.record("wait");
  workspace_->recorder.record(workspace_->viewport.camera);
  for (const std::string& line : script_lines(workspace_->viewport.options.lighting))
    workspace_->recorder.record(line);
  workspace_->recorder.record(std::string("screenshot ") + name);
  const auto image = renderer_->read_pixels();
  const Status written = image.is_ok() ? write_png(*image, name) : image.status();
  if (!written.is_ok()) return workspace_->log.failure("screenshot", written);
  std::error_code ignored;
  workspace_->log.info("saved " + std::filesystem::absolute(name, ignored).string());
}

}  // namespace burnish
