// The part of PostgresJournal for servers that share it: who holds which session, and for whom.

#include "server/journal/postgres_holding.h"
#include "server/journal/postgres_journal.h"
#include "server/metrics/metrics.h"

namespace burnish {

// A new epoch in any case: whatever this server sent before, and the database still works on, comes
// too late. The commit waits for a standby, so what is read afterwards is kept there too. A server
// that drains gives its sessions to whoever asks: the epoch stops what it still writes.
Status PostgresJournal::hold(const std::string& session_id) {
  return queue_->run(
      [&](PgConnection& database, Holdings& holdings) -> Status {
        const PgStatement take{
            "UPDATE sessions SET owner = CAST(NULLIF($2, '') AS uuid), epoch = epoch + 1,"
            " held_for = CASE WHEN owner = CAST(NULLIF($2, '') AS uuid) THEN held_for END WHERE id "
            "= $1 AND (owner IS NULL OR owner = CAST(NULLIF($2, '') AS uuid)"
            " OR owner IN (SELECT id FROM nodes WHERE draining)) RETURNING epoch",
            {session_id, PgText{holdings.life}}};
        const PgOutcome taken = database.transact({&take, 1});
        RETURN_IF_ERROR(status_of(taken));
        const PgReply& held = taken.replies[0];
        if (held.rows() == 0) return who_holds(database, session_id, holdings);
        if (!holdings.epochs.contains(session_id)) metrics().add(Count::kSessionsClaimed, 1);
        holdings.epochs[session_id] = held.integer(0, 0);
        return Status::ok();
      },
      PostgresQueue::Repeat::kOnce);
}

Status PostgresJournal::charge(const std::string& session_id, const std::string& user,
                               uint64_t sessions_max) {
  if (user.empty() || !is_shared_) return Status::ok();
  return queue_->run(
      [&](PgConnection& database, Holdings& holdings) -> Status {
        ASSIGN_OR_RETURN(const PgReply others,
                         database.run({"SELECT count(*) FROM sessions WHERE held_for = $1"
                                       " AND owner IS NOT NULL AND id <> $2",
                                       {user, session_id}}));
        const auto count = static_cast<uint64_t>(others.integer(0, 0));
        if (count >= sessions_max)
          return resource_exhausted(
              "sessions open of user " + user + " on all servers: " + std::to_string(count) +
              "; limits.sessions_per_user is " + std::to_string(sessions_max));
        const Holding holding = holdings.of(session_id);
        const PgStatement charge{
            "UPDATE sessions SET held_for = $2 WHERE id = $1 AND " + is_held(3, 4),
            {session_id, user, holding.epoch, PgText{holding.life}}};
        return change_held(database, charge, session_id, holdings);
      },
      PostgresQueue::Repeat::kOnce);
}

Result<std::optional<ServerPlace>> PostgresJournal::roomier_server(uint64_t bytes) {
  std::optional<ServerPlace> place;
  RETURN_IF_ERROR(queue_->run(
      [&](PgConnection& database, Holdings& holdings) -> Status {
        ASSIGN_OR_RETURN(
            const PgReply found,
            database.run({"SELECT name, address FROM nodes WHERE NOT draining"
                          " AND id IS DISTINCT FROM CAST(NULLIF($1, '') AS uuid)"
                          " AND lease_until > clock_timestamp() AND bytes_max - bytes_taken > $2"
                          " ORDER BY bytes_max - bytes_taken DESC, name LIMIT 1",
                          {PgText{holdings.life}, static_cast<int64_t>(bytes)}}));
        if (found.rows() > 0) place = ServerPlace{found.bytes(0, 1), found.bytes(0, 0)};
        return Status::ok();
      },
      PostgresQueue::Repeat::kOnce));
  return place;
}

void PostgresJournal::release(const std::string& session_id) {
  queue_->start([session_id](PgConnection& database, Holdings& holdings) {
    const Holding holding = holdings.of(session_id);
    holdings.epochs.erase(session_id);
    return database
        .run({"UPDATE sessions SET owner = NULL, held_for = NULL WHERE id = $1 AND epoch = $2"
              " AND owner = CAST(NULLIF($3, '') AS uuid)",
              {session_id, holding.epoch, PgText{holding.life}}})
        .status();
  });
}

void PostgresJournal::begin_life(const std::string& life) {
  is_shared_ = true;
  queue_->start([life](PgConnection& database, Holdings& holdings) {
    holdings = {life, {}};
    return database
        .run({"SELECT set_config('application_name', $1, false)", {PgText{"burnish " + life}}})
        .status();
  });
}

}  // namespace burnish
