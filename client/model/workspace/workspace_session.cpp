#include <algorithm>
#include <ctime>
#include <utility>

#include "client/model/documents/open_document.h"
#include "client/model/documents/session_choice.h"
#include "client/model/files/scan_files.h"
#include "client/model/workspace/session_pictures.h"
#include "client/model/workspace/workspace.h"
#include "client/report/length_text.h"
#include "client/scene/picture_mark.h"
#include "common/mesh/rewrite/left_out/left_out.h"

namespace burnish {

void Workspace::open(const SessionWish& wish) {
  open_chosen([wish](Connection&) -> Result<SessionWish> { return wish; });
}

std::shared_ptr<Activity> Workspace::opening_activity() {
  return std::make_shared<Activity>("Opening");
}

void Workspace::open_chosen(Choice choice, const std::shared_ptr<Activity>& activity) {
  if (!begins_opening()) return;
  start_activity(activity, [this, activity, connection = connection_,
                            choice = std::move(choice)](const Progress& progress) {
    connection->bring_back(progress);
    const auto wish = std::make_shared<Result<SessionWish>>(choice(*connection));
    return [this, activity, connection, wish] {
      wish->is_ok() ? open_wish(connection, **wish, activity)
                    : fail_opening(activity, wish->status());
    };
  });
}

// A large scan takes seconds until it can be edited: what there is of it is shown meanwhile.
void Workspace::open_wish(const std::shared_ptr<Connection>& connection, const SessionWish& wish,
                          const std::shared_ptr<Activity>& activity) {
  coming_ = std::make_shared<Coming>(connection, wish, activity);
  run_opener(
      connection,
      [coming = coming_](const std::shared_ptr<Connection>& server, const Progress& progress) {
        return open_document(server, coming->wish, progress, &coming->is_over);
      },
      activity);
  if (!has_picture()) look_early();
}

void Workspace::open_again(int depth) {
  if (!document_) return;
  open_by(
      [session = document_->session().id, scan = document_->scan().scan, depth](
          const std::shared_ptr<Connection>& connection, const Progress& progress) {
        return open_at_depth(connection, session, scan, depth, progress);
      },
      std::make_shared<Activity>("Opening at depth " + std::to_string(depth)));
}

bool Workspace::begins_opening() {
  if (!need_connection("open")) {
    forget_raw();
    return false;
  }
  return !std::exchange(opening_, true);
}

void Workspace::open_by(Opener opener, const std::shared_ptr<Activity>& activity) {
  if (begins_opening()) run_opener(connection_, std::move(opener), activity);
}

void Workspace::run_opener(const std::shared_ptr<Connection>& connection, Opener opener,
                           const std::shared_ptr<Activity>& activity) {
  start_activity(
      activity, [this, activity, connection, opener = std::move(opener)](const Progress& progress) {
        connection->bring_back(progress);
        auto opened = std::make_shared<Result<OpenedDocument>>(opener(connection, progress));
        return [this, activity, opened] { take_opened(activity, *opened); };
      });
}

void Workspace::take_opened(const std::shared_ptr<Activity>& activity,
                            Result<OpenedDocument>& opened) {
  if (!opened.is_ok()) return fail_opening(activity, opened.status());
  end_opening();
  if (activity == raw_work_ && begins_again()) return delete_if_new(*opened);
  show(std::move(*opened));
}

void Workspace::end_opening() {
  opening_ = false;
  if (coming_) coming_->is_over = true;
  coming_.reset();
}

void Workspace::fail_opening(const std::shared_ptr<Activity>& activity, const Status& why) {
  end_opening();
  if (activity == raw_work_ && begins_again()) return;
  forget_raw();
  log.failure("open", why);
}

// A session that nobody has seen is of no use to anybody.
void Workspace::delete_if_new(const OpenedDocument& opened) {
  if (opened.is_new) delete_session(opened.session);
}

void Workspace::join(const SessionInfo& session) {
  open(wish_to_join(session));
}

void Workspace::join_by_name(const std::string& session) {
  if (!need_connection("join")) return;
  tasks_.start([this, connection = connection_, session](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const auto sessions = connection->list_sessions();
    return [this, session, sessions] {
      if (!sessions.is_ok()) return log.failure("join", sessions.status());
      for (const SessionInfo& each : *sessions)
        if (each.name == session || each.id == session) return join(each);
      log.failure("join", not_found("the server has no session '" + session + "'"));
    };
  });
}

void Workspace::reopen(const RecentSession& recent) {
  when_connected_.clear();
  if (recent.server.empty()) {
    connect_privately();
  } else {
    connect(recent.server);
  }
  when_connected([this, recent] {
    open_chosen([recent](Connection& server) -> Result<SessionWish> {
      ASSIGN_OR_RETURN(const auto sessions, server.list_sessions());
      return session_of_recent(recent, sessions);
    });
  });
}

void Workspace::show(OpenedDocument opened) {
  leave_document();
  if (!opened.lacks.empty()) log.warning(opened.lacks);
  auto document =
      std::make_unique<Document>(std::move(opened), tasks_, log, recorder,
                                 DocumentOptions{options_.budget, options_.is_software,
                                                 options_.pages, options_.wake, options_.clock});
  // The surface is on the screen already.
  const bool goes_on = raw_ && raw_->triangles == document->scan().scan.statistics.triangles;
  raw_triangles_ = goes_on ? drawn_triangles(*raw_) : 0;
  forget_raw();
  const Status shown = document->open(renderer_);
  if (!shown.is_ok()) return log.failure("open", shown);
  Brush& brush = document->brush().brush;
  brush.radius = preferences.brush_radius_part * document->diagonal();
  brush.strength = preferences.brush_strength;
  brush.beta = preferences.brush_beta;
  document_ = std::move(document);
  document_server_ = recent_server();
  ++pictures_begun_;
  goes_on ? viewport.take_over(*document_) : viewport.begin(*document_);
  restore_view(goes_on);
  recorder.record("join " + document_->session().name);
  remember_document();
  save_preferences();
}

void Workspace::remember_document() {
  const SessionInfo& session = document_->session();
  const ScanInfo& scan = document_->scan().scan;
  remember(preferences.recent, {.server = recent_server(),
                                .session = session.name,
                                .scan = session.scan_id,
                                .id = session.id,
                                .scan_name = scan.name,
                                .shown_unix_seconds = std::time(nullptr),
                                .size_bytes = bytes_on_disk(scan)});
}

Unsaved Workspace::unsaved() const {
  const auto files = std::ranges::count_if(
      activities_, [](const auto& activity) { return activity->makes_file(); });
  return {document_ ? document_->unacknowledged() : 0, static_cast<size_t>(files)};
}

// Each edit is saved as it is made, so there is nothing to do.
void Workspace::tell_saved() {
  if (unsaved().is_there()) return log.warning(text_of(unsaved()) + " yet");
  log.info("all edits are saved; Export writes a file");
}

std::filesystem::path Workspace::picture_folder() const {
  if (options_.preferences.empty()) return {};
  return options_.preferences.parent_path() / "pictures";
}

void Workspace::keep_session_picture() {
  if (!document_ || !is_drawn_ || picture_folder().empty() || preferences.recent.empty()) return;
  if (shows_trial_) return;  // the picture is not of the session's values
  const auto image = renderer_.read_pixels();
  if (!image.is_ok()) return;
  const Status kept =
      keep_picture(picture_folder(), preferences.recent.front(), *image, preferences.recent);
  if (!kept.is_ok()) log.failure("picture of the session", kept);
}

Status Workspace::check_picture() const {
  if (!document_ || !document_->may_show_trial()) return Status::ok();
  return unavailable("the server has not ended the trial of a strength, and the picture shows it");
}

Result<Image> Workspace::read_picture(const std::optional<ScaleBar>& bar) const {
  ASSIGN_OR_RETURN(Image image, renderer_.read_pixels());
  const std::string lack = document_ ? document_->picture_lack() : std::string();
  if (!lack.empty()) mark_picture(image, lack);
  const std::string unit = document_ ? document_->unit() : std::string();
  if (bar) draw_scale_bar(image, *bar, length_text(bar->length, unit));
  return image;
}

const StrengthStrip::Picture* Workspace::keep_strength_picture() {
  if (!document_ || !is_drawn_ || !strip.wants_picture(*document_)) return nullptr;
  const auto image = renderer_.read_pixels();
  if (image.is_ok()) return &strip.take(*image, *document_);
  log.failure("picture of a strength", image.status());
  strip.close(document_.get());
  return nullptr;
}

void Workspace::leave_document() {
  keep_session_picture();
  strip.close(document_.get());
  is_drawn_ = false;
  save_preferences();
  if (const Unsaved lost{.edits = unsaved().edits}; lost.is_there())
    log.warning(document_->session().name + ": " + text_of(lost) + " and will be lost");
  document_.reset();
}

void Workspace::close_document() {
  leave_document();
  refresh_library();
}

void Workspace::export_mesh(const std::filesystem::path& file, bool exact, bool with_record) {
  if (!document_) return;
  const Status target = check_export(file);
  if (!target.is_ok()) return log.failure("export", target);
  recorder.record("wait");
  recorder.record("export " + file.string() + (exact ? " exact" : "") +
                  (with_record ? " record" : ""));
  start_activity(std::make_shared<Activity>("Exporting " + file.filename().string(), true),
                 [this, file, wish = ExportWish{.exact = exact, .deviation = with_record},
                  connection = document_->opened().connection,
                  session = document_->session()](const Progress& progress) {
                   connection->bring_back(progress);
                   const auto outcome = export_to_file(*connection, session, wish, file, progress);
                   return [this, file, outcome] { tell_exported(file, outcome); };
                 });
}

void Workspace::tell_exported(const std::filesystem::path& file,
                              const Result<ExportSummary>& outcome) {
  if (!outcome.is_ok()) return log.failure("export", outcome.status());
  ++exports_done_;
  log.info("exported " + file.string() + ", " + std::to_string(outcome->vertices) + " vertices");
  if (!outcome->left_out.empty())
    log.warning("not in " + file.filename().string() + ": " + left_out_text(outcome->left_out));
  if (!outcome->pictures.empty()) log.info(file.filename().string() + ": " + outcome->pictures);
  if (!outcome->lost_volume.empty())
    log.warning(file.filename().string() + ": " + outcome->lost_volume);
}

void Workspace::fork(const std::string& name, const std::string& checkpoint) {
  if (!document_) return;
  start_activity("Forking", [this, connection = connection_,
                             wish = ForkWish{.source = document_->session().id,
                                             .name = name,
                                             .checkpoint = checkpoint}](const Progress& progress) {
    connection->bring_back(progress);
    const auto forked = connection->fork_session(wish);
    return [this, forked] {
      if (!forked.is_ok()) return log.failure("fork", forked.status());
      log.info("forked as " + forked->session.name);
      join(forked->session);
    };
  });
}

// The surface that is shown until its session is there.

void Workspace::look_early() {
  tasks_.start([this, coming = coming_, triangles_max = options_.budget.triangles](
                   const StopToken& stop) -> Tasks::Completion {
    const auto is_wanted = [&] {
      return !coming->is_over && !coming->activity->is_cancelled() && !stop.stop_requested();
    };
    const auto early = std::make_shared<Result<RawScan>>(
        fetch_raw_scan(*coming->connection, coming->wish.scan, triangles_max, is_wanted));
    return [this, coming, early] {
      if (coming == coming_) take_early(*early);
    };
  });
}

// A failure of the server is told by the opening.
void Workspace::take_early(Result<RawScan>& early) {
  if (has_picture() || !early.is_ok() || !put_into(renderer_, *early).is_ok()) return;
  raw_.emplace(std::move(*early));
  ++pictures_begun_;
  viewport.begin(raw_->box, raw_->up);
  const auto recent = std::ranges::find_if(preferences.recent, [&](const RecentSession& each) {
    return each.server == recent_server() && each.session == coming_->wish.name;
  });
  if (recent != preferences.recent.end()) see_as_kept(recent->id);
}

bool Workspace::keeps_raw_picture(const Camera& shown) const {
  if (!document_ || document_->is_picture_fine()) return false;
  Camera camera = viewport.camera;
  camera.scene_radius = shown.scene_radius;
  const CutStatus now = document_->surface().status();
  const uint64_t whole = document_->scan().scan.statistics.triangles;
  const bool is_coarser = now.triangles_in_view == 0 ||
                          now.triangles_drawn * whole < now.triangles_in_view * raw_triangles_;
  return camera == shown && raw_triangles_ > 0 && is_coarser;
}

void Workspace::close_raw(const std::filesystem::path& file) {
  if (raw_file_ != file) return;
  raw_ && raw_->file != file ? raw_file_.clear() : forget_raw();
}

void Workspace::forget_raw() {
  raw_file_.clear();
  raw_.reset();
  raw_work_.reset();
  raw_depth_ = 0;
  raw_begins_again_ = false;
}

bool Workspace::may_open(const std::filesystem::path& file) const {
  return !document_ && !opening_ && (raw_file_.empty() || raw_file_ == file);
}

// Returns whether this file is to take the open session's place; it was asked to once.
bool Workspace::takes_place(const std::filesystem::path& file) {
  if (replacing_ != file) return false;
  replacing_.clear();
  return document_ != nullptr && !opening_;
}

bool Workspace::may_leave() {
  if (document_->unacknowledged() == 0) return true;
  log.warning(document_->session().name + " stays open: its edits wait for the server");
  return false;
}

// How the user last saw the session.

// The folder of the preferences keeps views, if there is one.
static std::filesystem::path views_file(const std::filesystem::path& preferences) {
  return preferences.empty() ? preferences
                             : std::filesystem::path(preferences).replace_filename("views.toml");
}

std::optional<ViewState> Workspace::kept_view(const std::string& session) const {
  const std::filesystem::path file = views_file(options_.preferences);
  return file.empty() ? std::nullopt : read_view(file, {recent_server(), session});
}

void Workspace::see_as_kept(const std::string& session) {
  const auto view = kept_view(session);
  if (!view) return;
  viewport.camera = view->camera;
  viewport.options = view->options;
}

// The camera of a raw scan that the session takes over stays: the user may have turned it.
void Workspace::restore_view(bool keeps_camera) {
  auto view = kept_view(document_->session().id);
  if (!view) return raise_axis();
  if (!keeps_camera) viewport.camera = view->camera;
  viewport.options = view->options;
  viewport.bookmarks = std::move(view->bookmarks);
  if (view->colour != ColourBy::kScan || document_->has_colours())
    document_->set_colour(view->colour);
}

// New sessions of a scan keep the axis that its user chose.
void Workspace::raise_axis() {
  const std::filesystem::path file = views_file(options_.preferences);
  const auto up = file.empty() ? std::nullopt : read_up(file, document_->scan().scan.id);
  if (up && *up != viewport.camera.up) return viewport.set_up(*up);
  if (!up && viewport.camera.up != UpAxis::kY)
    log.info("taken for land: z is up; Camera, Up changes it");
}

void Workspace::record_picture(const std::filesystem::path& file) {
  recorder.record("wait");
  recorder.record(viewport.camera);
  for (const std::string& line : script_lines(viewport.options.lighting)) recorder.record(line);
  recorder.record(std::string("scale_bar ") + (viewport.options.scale_bar ? "on" : "off"));
  recorder.record("screenshot " + file.string());
}

void Workspace::save_view() {
  const std::filesystem::path file = views_file(options_.preferences);
  if (file.empty()) return;
  const ViewKey key{document_server_, document_->session().id};
  const Status written = write_view(file, key,
                                    {document_->scan().scan.id, viewport.camera, viewport.options,
                                     document_->colour(), viewport.bookmarks});
  if (!written.is_ok()) log.failure("views", written);
}

}  // namespace burnish
