#include "server/journal/postgres_holding.h"

#include "common/base/server_place.h"
#include "server/metrics/metrics.h"

namespace burnish {

Status status_of(const PgOutcome& outcome) {
  if (outcome.end == PgOutcome::End::kUnknown) return WriteOutcome::unknown(outcome.why).status();
  return outcome.why;
}

Status who_holds(PgConnection& database, const std::string& session_id, const Holdings& holdings) {
  ASSIGN_OR_RETURN(
      const PgReply holder,
      database.run({"SELECT nodes.name, nodes.address, nodes.id = CAST(NULLIF($2, '') AS uuid)"
                    " FROM sessions LEFT JOIN nodes ON nodes.id = owner WHERE sessions.id = $1",
                    {session_id, PgText{holdings.life}}}));
  if (holder.rows() == 0) return not_found("no session has the id '" + session_id + "'");
  const ServerPlace place{holder.bytes(0, 1), holder.bytes(0, 0)};
  const bool is_me = !holder.bytes(0, 2).empty() && holder.integer(0, 2) != 0;
  if (place.node.empty() || is_me)
    return unavailable("this server did not hold the session at this moment; try again");
  metrics().add(Count::kCallsMoved, 1);
  const std::string where = place.address.empty() ? "" : " (" + place.address + ")";
  return Status::moved(place.text(), "server " + place.node + where + " holds the session");
}

Status change_held(PgConnection& database, const PgStatement& change, const std::string& session_id,
                   const Holdings& holdings) {
  const PgOutcome changed = database.transact({&change, 1});
  RETURN_IF_ERROR(status_of(changed));
  if (changed.replies[0].affected() > 0) return Status::ok();
  return who_holds(database, session_id, holdings);
}

}  // namespace burnish
