#include "client/model/workspace/workspace.h"

#include <algorithm>

#include "client/model/documents/session_choice.h"
#include "client/model/files/scan_files.h"
#include "common/base/text.h"

namespace burnish {

Workspace::Workspace(PageRenderer& renderer, Preferences remembered, WorkspaceOptions options)
    : preferences(std::move(remembered)),
      renderer_(renderer),
      options_(std::move(options)),
      tasks_(options_.wake) {
  viewport.options.lighting = preferences.lighting;
}

void Workspace::update(bool draws) {
  tasks_.drain();
  if (raw_) viewport.update(raw_->box);
  if (!document_) return;
  document_->update(draws);
  viewport.update(*document_);
  strip.follow(*document_, viewport);
}

void Workspace::on_picture(double ms, std::optional<double> surface_ms) {
  if (document_) document_->on_picture(ms, surface_ms);
}

Status Workspace::look() {
  if (!document_) return Status::ok();
  RETURN_IF_ERROR(viewport.look(*document_));
  // The trial has left without a trace.
  if (document_->picture_changes() == drawn_changes_) shows_trial_ &= document_->may_show_trial();
  return Status::ok();
}

Status Workspace::draw() {
  is_drawn_ = document_ != nullptr;
  shows_trial_ = document_ && document_->may_show_trial();
  drawn_changes_ = document_ ? document_->picture_changes() : 0;
  if (document_) return viewport.draw(renderer_, *document_);
  if (!raw_) return Status::ok();
  DrawStyle style = style_of(*raw_);
  style.lighting = viewport.options.lighting;
  return renderer_.draw(viewport.camera, viewport.size(), style, raw_->patches);
}

void Workspace::start_activity(const std::string& title, Step step) {
  start_activity(std::make_shared<Activity>(title), std::move(step));
}

void Workspace::start_activity(const std::shared_ptr<Activity>& activity, Step step) {
  activities_.push_back(activity);
  tasks_.start([this, activity, step = std::move(step)](const StopToken& stop) {
    const Progress told = progress_of(activity, stop);
    Tasks::Completion completion = step([this, &told](std::string_view phase, double fraction) {
      const bool go_on = told(phase, fraction);
      wake();
      return go_on;
    });
    return [this, activity, completion = std::move(completion)] {
      std::erase(activities_, activity);
      completion();
    };
  });
}

std::string with_port(const std::string& server) {
  const bool is_path = server.starts_with("unix:");
  const size_t colons = static_cast<size_t>(std::count(server.begin(), server.end(), ':'));
  const bool has_port =
      server.starts_with('[') ? server.find("]:") != std::string::npos : colons > 0;
  return is_path || has_port ? server : server + ":7411";
}

void Workspace::connect(const std::string& typed) {
  connect(server_at(preferences.servers, with_port(typed)));
}

/// Opens a connection that the server lets in: the first call tells whether the token is right.
static Result<Connection> open_as_user(const std::string& server, std::chrono::milliseconds timeout,
                                       const ConnectionTrust& trust, const std::string& user) {
  ASSIGN_OR_RETURN(Connection connection, Connection::open(server, timeout, trust));
  connection.set_user(user);
  RETURN_IF_ERROR(connection.list_scans().status());
  return connection;
}

void Workspace::connect(const KnownServer& wanted) {
  const std::string server = wanted.address;
  library_ = {.state = Library::State::kConnecting, .server = server};
  connection_.reset();
  connecting_ = wanted;
  tasks_.start([this, server, timeout = options_.timeout, trust = trust_in(wanted, options_.trust),
                user = wanted.user.empty() ? preferences.user
                                           : wanted.user](StopToken) -> Tasks::Completion {
    auto opened = std::make_shared<Result<Connection>>(open_as_user(server, timeout, trust, user));
    return [this, server, opened] {
      if (library_.server == server) take_connection(std::move(*opened));
    };
  });
}

Result<Connection> open_private_connection(const PrivateServerOptions& options,
                                           std::chrono::milliseconds timeout,
                                           const Progress& progress) {
  constexpr int kTries = 3;  // the server may just have ended because nobody used it
  for (int tries = 1;; ++tries) {
    ASSIGN_OR_RETURN(const std::string address, find_private_server(options, progress));
    auto opened = Connection::open(address, timeout);
    if (opened.is_ok())
      opened->set_starter([options](const Progress& while_starting) {
        return find_private_server(options, while_starting).status();
      });
    if (opened.is_ok() || tries == kTries) return opened;
  }
}

void Workspace::connect_privately() {
  library_ = {.state = Library::State::kConnecting, .server = "", .is_private = true};
  connection_.reset();
  start_activity(
      "Starting a private server", [this, user = preferences.user](const Progress& progress) {
        auto opened = std::make_shared<Result<Connection>>(
            open_private_connection(options_.private_server, options_.timeout, progress));
        if (opened->is_ok()) (*opened)->set_user(user);
        return [this, opened] {
          if (library_.is_private) take_connection(std::move(*opened));
        };
      });
}

uint64_t Workspace::server_memory_bytes() const {
  return library_.is_private ? private_server_memory_bytes() : 0;
}

void Workspace::take_connection(Result<Connection> connection) {
  if (!connection.is_ok()) {
    library_.state = Library::State::kFailed;
    when_connected_.clear();
    forget_raw();
    library_.problem = connection.status().message();
    const StatusCode code = connection.status().code();
    library_.refuses_user =
        code == StatusCode::kUnauthenticated || code == StatusCode::kPermissionDenied;
    return log.failure("connection", connection.status());
  }
  library_.state = Library::State::kConnected;
  if (!library_.is_private) remember_server(preferences.servers, connecting_);
  connection_ = std::make_shared<Connection>(std::move(*connection));
  refresh_library();
  for (const auto& next : std::exchange(when_connected_, {})) next();
}

void Workspace::save_preferences() {
  if (document_) {
    const Brush& brush = document_->brush().brush;
    preferences.brush_radius_part = brush.radius / document_->diagonal();
    preferences.brush_strength = brush.strength;
    if (!brush.has_own_limits()) preferences.brush_beta = brush.beta;
    preferences.lighting = viewport.options.lighting;
    save_view();
  }
  if (options_.preferences.empty()) return;
  const Status written = write_preferences(preferences, options_.preferences);
  if (!written.is_ok()) log.failure("configuration", written);
}

// The scans and sessions of the server.

bool Workspace::need_connection(const std::string& what) {
  if (connection_) return true;
  log.warning(what + ": connect to a server first");
  return false;
}

void Workspace::when_connected(std::function<void()> what) {
  if (connection_) return what();
  when_connected_.push_back(std::move(what));
  if (library_.state != Library::State::kConnecting) connect_privately();
}

void Workspace::refresh_library() {
  if (!connection_) return;
  tasks_.start([this, connection = connection_](StopToken) -> Tasks::Completion {
    connection->bring_back();
    auto scans = connection->list_scans();
    auto sessions = connection->list_sessions();
    return [this, connection, scans = std::move(scans), sessions = std::move(sessions)] {
      if (connection != connection_) return;
      if (!scans.is_ok()) return log.failure("list of scans", scans.status());
      if (!sessions.is_ok()) return log.failure("list of sessions", sessions.status());
      library_.scans = *scans;
      library_.sessions = *sessions;
      if (follow_names(preferences.recent, recent_server(), *sessions, *scans)) save_preferences();
    };
  });
}

void Workspace::import_scan(const std::filesystem::path& file, Opening opening) {
  if (options_.shows_raw && may_open(file) && raw_file_.empty() && can_be_raw(file))
    return show_raw_and_import(file, opening);
  const auto activity = std::make_shared<Activity>("Importing " + file.filename().string());
  when_connected([this, file, opening, activity] { import_there(file, opening, activity); });
}

void Workspace::import_in_place(const std::filesystem::path& file) {
  if (document_ && replacing_.empty()) replacing_ = file;
  import_scan(file);
}

void Workspace::import_there(const std::filesystem::path& file, Opening opening,
                             const std::shared_ptr<Activity>& activity) {
  const auto connection = connection_;
  const int depth = raw_depth_;
  start_activity(activity,
                 [this, connection, file, opening, activity, depth](const Progress& progress) {
                   connection->bring_back(progress);
                   std::vector<std::string> missing;
                   auto outcome = import_file(*connection, file, depth, missing, progress);
                   return [this, file, opening, activity, missing, outcome = std::move(outcome)] {
                     if (activity == raw_work_ && begins_again()) return;
                     const bool replaces = takes_place(file);
                     if (!outcome.is_ok()) {
                       close_raw(file);
                       return log.failure("import of " + file.string(), outcome.status());
                     }
                     tell_imported(file, *outcome);
                     if (!missing.empty())
                       log.warning(missing_text(file.filename().string(), missing));
                     refresh_library();
                     if (may_open(file) || (replaces && may_leave()))
                       open_scan(outcome->scan, opening, raw_depth_, activity);
                   };
                 });
}

void Workspace::tell_imported(const std::filesystem::path& file, const ImportOutcome& outcome) {
  const std::string& name = outcome.scan.name;
  if (outcome.already_present && name != file.stem().string())
    return log.warning(file.filename().string() + " has the bytes of the scan " + name +
                       ", which is there already; it keeps that name. Rename on the start page "
                       "changes it");
  if (name != file.stem().string())
    return log.info("imported " + name + "; the server does not take the name " +
                    file.stem().string() + ", or another scan has it");
  log.info((outcome.already_present ? "already there: " : "imported ") + name);
}

void Workspace::open_scan(const ScanInfo& scan, Opening opening, int depth) {
  open_scan(scan, opening, depth, opening_activity());
}

void Workspace::open_scan(const ScanInfo& scan, Opening opening, int depth,
                          const std::shared_ptr<Activity>& activity) {
  std::vector<std::string> recent;
  for (const RecentSession& each : preferences.recent)
    if (each.server == recent_server()) recent.push_back(each.session);
  open_chosen(
      [scan, opening, recent, depth](Connection& server) -> Result<SessionWish> {
        ASSIGN_OR_RETURN(const auto sessions, server.list_sessions());
        return opening == Opening::kGoOn ? session_to_go_on(scan, sessions, recent, depth)
                                         : new_session(scan, sessions, depth);
      },
      activity);
}

void Workspace::delete_session(const SessionInfo& session) {
  std::erase_if(preferences.recent, [&](const RecentSession& each) {
    return each.session == session.name && each.scan == session.scan_id;
  });
  change_library("delete",
                 [id = session.id](Connection& server) { return server.delete_session(id); });
}

void Workspace::delete_scan(const std::string& id) {
  change_library("delete", [id](Connection& server) -> Status {
    ASSIGN_OR_RETURN(const auto sessions, server.list_sessions());
    for (const SessionInfo& session : sessions)
      if (session.scan_id == id) RETURN_IF_ERROR(server.delete_session(session.id));
    return server.delete_scan(id).status();
  });
}

void Workspace::rename_session(const SessionInfo& session, const std::string& name) {
  change_library("rename", [id = session.id, name](Connection& server) {
    return server.rename_session(id, name).status();
  });
}

void Workspace::rename_scan(const std::string& id, const std::string& name) {
  change_library("rename",
                 [id, name](Connection& server) { return server.rename_scan(id, name).status(); });
}

void Workspace::change_library(const std::string& what, std::function<Status(Connection&)> change) {
  if (!need_connection(what)) return;
  tasks_.start([this, connection = connection_, what,
                change = std::move(change)](StopToken) -> Tasks::Completion {
    connection->bring_back();
    const Status status = change(*connection);
    return [this, what, status] {
      if (!status.is_ok()) log.failure(what, status);
      refresh_library();
    };
  });
}

}  // namespace burnish
