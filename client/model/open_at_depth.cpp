// A session goes on at another depth, in a fork.

#include "client/model/session_choice.h"
#include "client/model/workspace.h"

namespace burnish {

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
