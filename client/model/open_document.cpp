#include "client/model/workspace.h"

namespace burnish {

// Prepares the scan before its session opens, so that users see the preparation and can cancel it.
Result<OpenedDocument> open_document(std::shared_ptr<Connection> connection,
                                     const SessionWish& wish, uint64_t triangles_max,
                                     const Progress& progress) {
  OpenedDocument opened;
  opened.server = connection->server();
  opened.connection = connection;
  opened.triangles_max = triangles_max;
  connection->bring_back(progress);
  RETURN_IF_ERROR(connection->prepare_scan(wish.scan, wish.key, progress).status());
  ASSIGN_OR_RETURN(const OpenedSession session, connection->open_session(wish));
  opened.session = session.session;
  const PreparedKey key = opened.session.key;
  ASSIGN_OR_RETURN(opened.scan, connection->describe_scan(opened.session.scan_id, key.depth));
  ASSIGN_OR_RETURN(View view,
                   connection->fetch_view({opened.session.scan_id, key, triangles_max}, progress));
  if (!report(progress, "computing normals", 0)) return cancelled("opening was cancelled");
  opened.view = std::make_shared<const View>(std::move(view));
  opened.mesh = make_view_mesh(*opened.view);
  ASSIGN_OR_RETURN(opened.state, connection->state(opened.session.id));
  ASSIGN_OR_RETURN(opened.history, connection->history(opened.session.id));
  return opened;
}

}  // namespace burnish
