#include "client/model/workspace.h"

#include <algorithm>

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
}

void Workspace::on_picture(double ms, std::optional<double> surface_ms) {
  if (document_) document_->on_picture(ms, surface_ms);
}

Status Workspace::look() {
  return document_ ? viewport.look(*document_) : Status::ok();
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
    if (!brush.edges) preferences.brush_beta = brush.beta;
    preferences.lighting = viewport.options.lighting;
    save_view();
  }
  if (options_.preferences.empty()) return;
  const Status written = write_preferences(preferences, options_.preferences);
  if (!written.is_ok()) log.failure("configuration", written);
}

}  // namespace burnish
