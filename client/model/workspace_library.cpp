#include <algorithm>

#include "client/model/scan_files.h"
#include "client/model/session_choice.h"
#include "client/model/workspace.h"
#include "common/mesh/rewrite/left_out.h"

namespace burnish {

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

void Workspace::import_there(const std::filesystem::path& file, Opening opening,
                             const std::shared_ptr<Activity>& activity) {
  const auto connection = connection_;
  const int depth = raw_depth_;
  start_activity(
      activity, [this, connection, file, opening, activity, depth](const Progress& progress) {
        connection->bring_back(progress);
        std::vector<std::string> missing;
        auto outcome = import_file(*connection, file, depth, missing, progress);
        return [this, file, opening, activity, missing, outcome = std::move(outcome)] {
          if (activity == raw_work_ && begins_again()) return;
          if (!outcome.is_ok()) {
            close_raw(file);
            return log.failure("import of " + file.string(), outcome.status());
          }
          tell_imported(file, *outcome);
          if (!missing.empty())
            log.warning("not beside " + file.filename().string() + ": " + left_out_text(missing));
          refresh_library();
          if (may_open(file)) open_scan(outcome->scan, opening, raw_depth_, activity);
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
