#include "client/model/workspace.h"

namespace burnish {

// Prepares the scan before its session opens, so that users see the preparation and can cancel it.
Result<OpenedDocument> open_document(std::shared_ptr<Connection> connection,
                                     const SessionWish& wish, const Progress& progress) {
  connection->bring_back(progress);
  RETURN_IF_ERROR(connection->prepare_scan(wish.scan, wish.key, progress).status());
  ASSIGN_OR_RETURN(const OpenedSession session, connection->open_session(wish));
  return fetch_document(std::move(connection), session.session, progress);
}

Result<OpenedDocument> fetch_document(std::shared_ptr<Connection> connection,
                                      const SessionInfo& session, const Progress& progress) {
  OpenedDocument opened;
  opened.server = connection->server();
  opened.connection = connection;
  opened.session = session;
  const std::string& scan = opened.session.scan_id;
  ASSIGN_OR_RETURN(opened.scan, connection->describe_scan(scan, opened.session.key.depth));
  if (!opened.scan.prepared)
    return data_loss("server " + opened.server + " does not describe the prepared scan");
  ASSIGN_OR_RETURN(const PagesDescription pages, connection->describe_pages(scan, progress));
  ASSIGN_OR_RETURN(opened.pages, open_pages(pages, scan));
  ASSIGN_OR_RETURN(opened.state, connection->state(opened.session.id));
  ASSIGN_OR_RETURN(opened.history, connection->history(opened.session.id));
  return opened;
}

}  // namespace burnish
