#include "client/model/workspace.h"

#include <algorithm>

namespace burnish {

Workspace::Workspace(PageRenderer& renderer, Preferences remembered, WorkspaceOptions options)
    : preferences(std::move(remembered)), renderer_(renderer), options_(std::move(options)) {
  if (!options_.wake) options_.wake = [] {};
}

Status Workspace::update() {
  tasks_.drain();
  if (!document_) return Status::ok();
  document_->update();
  return viewport.update(renderer_, *document_);
}

Status Workspace::look() {
  return document_ ? viewport.look(*document_) : Status::ok();
}

void Workspace::start_activity(const std::string& title, Step step) {
  const auto activity = std::make_shared<Activity>(title);
  activities_.push_back(activity);
  tasks_.start([this, activity, step = std::move(step)](const std::stop_token& stop) {
    const Progress told = progress_of(activity, stop);
    Tasks::Completion completion = step([this, &told](std::string_view phase, double fraction) {
      const bool go_on = told(phase, fraction);
      wake();
      return go_on;
    });
    wake();
    return [this, activity, completion = std::move(completion)] {
      std::erase(activities_, activity);
      completion();
    };
  });
}

void Workspace::connect(const std::string& server) {
  library_ = {.state = Library::State::kConnecting, .server = server};
  connection_.reset();
  tasks_.start([this, server, timeout = options_.timeout, trust = options_.trust,
                user = preferences.user](std::stop_token) -> Tasks::Completion {
    auto opened = std::make_shared<Result<Connection>>(Connection::open(server, timeout, trust));
    if (opened->is_ok()) (*opened)->set_user(user);
    wake();
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

void Workspace::take_connection(Result<Connection> connection) {
  if (!connection.is_ok()) {
    library_.state = Library::State::kFailed;
    library_.problem = connection.status().message();
    return log.failure("connection", connection.status());
  }
  library_.state = Library::State::kConnected;
  if (!library_.is_private) preferences.server = library_.server;
  connection_ = std::make_shared<Connection>(std::move(*connection));
  refresh_library();
  if (const auto next = std::exchange(when_connected_, nullptr)) next();
}

bool Workspace::need_connection(const std::string& what) {
  if (connection_) return true;
  log.warning(what + ": connect to a server first");
  return false;
}

void Workspace::refresh_library() {
  if (!connection_) return;
  tasks_.start([this, connection = connection_](std::stop_token) -> Tasks::Completion {
    connection->bring_back();
    auto scans = connection->list_scans();
    auto sessions = connection->list_sessions();
    wake();
    return [this, connection, scans = std::move(scans), sessions = std::move(sessions)] {
      if (connection != connection_) return;
      if (!scans.is_ok()) return log.failure("list of scans", scans.status());
      if (!sessions.is_ok()) return log.failure("list of sessions", sessions.status());
      library_.scans = *scans;
      library_.sessions = *sessions;
    };
  });
}

void Workspace::import_scan(const std::filesystem::path& file) {
  if (!need_connection("import")) return;
  const auto connection = connection_;
  start_activity("Importing " + file.filename().string(),
                 [this, connection, file](const Progress& progress) {
                   connection->bring_back(progress);
                   auto outcome = connection->import_scan(file, file.stem().string(), {}, progress);
                   return [this, file, outcome = std::move(outcome)] {
                     if (!outcome.is_ok())
                       return log.failure("import of " + file.string(), outcome.status());
                     log.info("imported " + outcome->scan.name);
                     refresh_library();
                     if (!document_ && !opening_) open({.scan = outcome->scan.id});
                   };
                 });
}

void Workspace::delete_scan(const std::string& id) {
  if (!need_connection("delete")) return;
  tasks_.start([this, connection = connection_, id](std::stop_token) -> Tasks::Completion {
    connection->bring_back();
    const Status status = connection->delete_scan(id).status();
    wake();
    return [this, status] {
      if (!status.is_ok()) log.failure("delete", status);
      refresh_library();
    };
  });
}

void Workspace::save_preferences() {
  if (document_) {
    const Brush& brush = document_->brush().brush;
    preferences.brush_radius_part = brush.radius / document_->diagonal();
    preferences.brush_strength = brush.strength;
    preferences.brush_beta = brush.beta;
  }
  if (options_.preferences.empty()) return;
  const Status written = write_preferences(preferences, options_.preferences);
  if (!written.is_ok()) log.failure("configuration", written);
}

}  // namespace burnish
