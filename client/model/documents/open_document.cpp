#include "client/model/documents/open_document.h"

#include "client/model/documents/session_choice.h"
#include "client/model/tasks/async_task.h"

namespace burnish {

// Prepares the scan before its session opens, so that users see the preparation and can cancel it.
Result<OpenedDocument> open_document(std::shared_ptr<Connection> connection,
                                     const SessionWish& wish, const Progress& progress,
                                     std::atomic<bool>* is_open) {
  connection->bring_back(progress);
  RETURN_IF_ERROR(connection->prepare_scan(wish.scan, wish.key, progress).status());
  if (!report(progress, "opening the session", 0)) return cancelled("opening was cancelled");
  ASSIGN_OR_RETURN(const OpenedSession session, connection->open_session(wish));
  if (is_open) *is_open = true;
  ASSIGN_OR_RETURN(OpenedDocument opened,
                   fetch_document(std::move(connection), session.session, progress));
  opened.is_new = !session.attached;
  return opened;
}

// Each answer takes a round trip, so all are asked for at once.
Result<OpenedDocument> fetch_document(std::shared_ptr<Connection> connection,
                                      const SessionInfo& session, const Progress& progress) {
  auto described =
      ask([&] { return connection->describe_scan(session.scan_id, session.key.depth); });
  auto state = ask([&] { return connection->state(session.id); });
  auto history = ask([&] { return connection->history(session.id); });
  OpenedDocument opened;
  opened.server = connection->server();
  opened.connection = connection;
  opened.session = session;
  ASSIGN_OR_RETURN(const PagesDescription pages,
                   connection->describe_pages(session.scan_id, progress));
  ASSIGN_OR_RETURN(opened.pages, open_pages(pages, session.scan_id));
  ASSIGN_OR_RETURN(opened.scan, described.take());
  if (!opened.scan.prepared)
    return data_loss("server " + opened.server + " does not describe the prepared scan");
  ASSIGN_OR_RETURN(opened.state, state.take());
  ASSIGN_OR_RETURN(opened.history, history.take());
  return opened;
}

// A session goes on at another depth, in a fork.

static std::string left_behind_text(uint64_t emptied_edits, const std::string& session) {
  if (emptied_edits == 0) return {};
  return "this session begins without the cells that " + std::to_string(emptied_edits) +
         (emptied_edits == 1 ? " edit" : " edits") + " of " + session +
         " set one by one: another depth has other cells";
}

Result<OpenedDocument> open_at_depth(std::shared_ptr<Connection> connection,
                                     const std::string& session, const ScanInfo& scan, int depth,
                                     const Progress& progress) {
  ASSIGN_OR_RETURN(const SessionState state, connection->state(session));
  ASSIGN_OR_RETURN(const auto sessions, connection->list_sessions());
  const SessionWish wish = new_session(scan, sessions, depth);
  RETURN_IF_ERROR(connection->prepare_scan(scan.id, wish.key, progress).status());
  ASSIGN_OR_RETURN(
      const ForkedSession forked,
      connection->fork_session({.source = session, .name = wish.name, .depth = depth}));
  ASSIGN_OR_RETURN(OpenedDocument opened,
                   open_document(connection, wish_to_join(forked.session), progress));
  opened.lacks = left_behind_text(forked.emptied_edits, state.session.name);
  return opened;
}

}  // namespace burnish
