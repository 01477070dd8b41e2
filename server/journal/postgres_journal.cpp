#include "server/journal/postgres_journal.h"

#include <algorithm>
#include <optional>

#include <spdlog/spdlog.h>

#include "server/journal/forked_edits.h"
#include "server/metrics/metrics.h"

namespace burnish {

using Repeat = PostgresQueue::Repeat;

Result<std::unique_ptr<PostgresJournal>> PostgresJournal::open(const PgAddress& address,
                                                               const std::filesystem::path& paint,
                                                               const PostgresPatience& patience) {
  ASSIGN_OR_RETURN(auto queue, PostgresQueue::open(address, patience));
  ASSIGN_OR_RETURN(auto cache, PaintCache::open(paint));
  return std::unique_ptr<PostgresJournal>(new PostgresJournal(std::move(queue), std::move(cache)));
}

template <typename T>
Result<T> PostgresJournal::read(const std::function<Result<T>(PgConnection&)>& work) {
  std::optional<Result<T>> result;
  const auto note = [&](PgConnection& database, Holdings&) {
    result = work(database);
    return result->status();
  };
  RETURN_IF_ERROR(queue_->run(note, Repeat::kOnce));
  return std::move(*result);
}

/// Returns the failure of a transaction, in the terms of a Journal.
static Status status_of(const PgOutcome& outcome) {
  if (outcome.end == PgOutcome::End::kUnknown) return WriteOutcome::unknown(outcome.why).status();
  return outcome.why;
}

Result<std::vector<SessionRecord>> PostgresJournal::sessions() {
  return read<std::vector<SessionRecord>>(
      [](PgConnection& database) -> Result<std::vector<SessionRecord>> {
        ASSIGN_OR_RETURN(const PgReply reply,
                         database.run({std::string(kSelectSessions) + " ORDER BY name", {}}));
        std::vector<SessionRecord> records;
        for (size_t row = 0; row < reply.rows(); ++row) {
          records.push_back(session_of_row(reply, row));
          if (records.back().is_damaged)
            spdlog::error("session {} ({}): its row in the journal is damaged", records.back().id,
                          records.back().name);
        }
        return records;
      });
}

Status PostgresJournal::create_session(const SessionRecord& record, const SessionRoles& roles) {
  return queue_->run(
      [&](PgConnection& database, Holdings& holdings) {
        const Holding holding{holdings.life, 1};
        const Status made =
            status_of(database.transact(make_session_rows(record, roles, holding, shares_scans_)));
        if (made.is_ok()) holdings.epochs[record.id] = holding.epoch;
        return made;
      },
      Repeat::kNever);
}

/// Says why this server does not hold a session.
static Status who_holds(PgConnection& database, const std::string& session_id,
                        const Holdings& holdings) {
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

/// Does a change of a held session. Fails: as who_holds() if it changes no row.
static Status change_held(PgConnection& database, const PgStatement& change,
                          const std::string& session_id, const Holdings& holdings) {
  const PgOutcome changed = database.transact({&change, 1});
  RETURN_IF_ERROR(status_of(changed));
  if (changed.replies[0].affected() > 0) return Status::ok();
  return who_holds(database, session_id, holdings);
}

// A new checksum must not turn a damaged row into a good one.
Status PostgresJournal::rename_session(const std::string& id, const std::string& name) {
  return queue_->run(
      [&](PgConnection& database, Holdings& holdings) -> Status {
        ASSIGN_OR_RETURN(const PgReply reply,
                         database.run({std::string(kSelectSessions) + " WHERE id = $1", {id}}));
        if (reply.rows() == 0) return not_found("no session has the id '" + id + "'");
        SessionRecord record = session_of_row(reply, 0);
        if (record.is_damaged)
          return data_loss("session " + record.name + ": its row in the journal is damaged");
        const std::string before = record.name;
        record.name = name;
        const Holding holding = holdings.of(id);
        const PgStatement change{
            "UPDATE sessions SET name = $2, checksum = $3 WHERE id = $1 AND name = $4 AND " +
                is_held(5, 6),
            {id, name, checksum_of(record), before, holding.epoch, PgText{holding.life}}};
        const Status renamed = change_held(database, change, id, holdings);
        return renamed.code() == StatusCode::kAlreadyExists
                   ? already_exists("session " + name + " already exists")
                   : renamed;
      },
      Repeat::kNever);
}

Status PostgresJournal::remove_session(const std::string& id) {
  RETURN_IF_ERROR(queue_->run(
      [&](PgConnection& database, Holdings& holdings) {
        const Holding holding = holdings.of(id);
        const PgStatement remove{"DELETE FROM sessions WHERE id = $1 AND " + is_held(2, 3),
                                 {id, holding.epoch, PgText{holding.life}}};
        const Status removed = change_held(database, remove, id, holdings);
        const bool is_gone = removed.is_ok() || removed.code() == StatusCode::kNotFound;
        if (is_gone) holdings.epochs.erase(id);
        return is_gone ? Status::ok() : removed;
      },
      Repeat::kNever));
  paint_->forget(id);
  return Status::ok();
}

// A new epoch in any case: whatever this server sent before, and the database still works on, comes
// too late. The commit waits for a standby, so what is read afterwards is kept there too.
Status PostgresJournal::hold(const std::string& session_id) {
  return queue_->run(
      [&](PgConnection& database, Holdings& holdings) -> Status {
        const PgStatement take{
            "UPDATE sessions SET owner = CAST(NULLIF($2, '') AS uuid), epoch = epoch + 1,"
            " held_for = CASE WHEN owner = CAST(NULLIF($2, '') AS uuid) THEN held_for END WHERE id "
            "= $1 AND (owner IS NULL"
            " OR owner = CAST(NULLIF($2, '') AS uuid)) RETURNING epoch",
            {session_id, PgText{holdings.life}}};
        const PgOutcome taken = database.transact({&take, 1});
        RETURN_IF_ERROR(status_of(taken));
        const PgReply& held = taken.replies[0];
        if (held.rows() == 0) return who_holds(database, session_id, holdings);
        if (!holdings.epochs.contains(session_id)) metrics().add(Count::kSessionsClaimed, 1);
        holdings.epochs[session_id] = held.integer(0, 0);
        return Status::ok();
      },
      Repeat::kOnce);
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
      Repeat::kOnce);
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
      Repeat::kOnce));
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

Result<uint64_t> PostgresJournal::fork_session(const SessionRecord& source, uint64_t edits,
                                               const SessionRecord& record,
                                               const SessionRoles& roles) {
  uint64_t emptied = 0;
  const auto fork = [&](PgConnection& database, Holdings& holdings) -> Status {
    ASSIGN_OR_RETURN(auto all, read_edit_rows(database, source.id));
    ASSIGN_OR_RETURN(const ForkedEdits forked,
                     edits_of_fork(std::move(all), edits, source, record));
    emptied = forked.emptied;
    const Holding holding{holdings.life, 1};
    std::vector<PgStatement> statements = make_session_rows(record, roles, holding, shares_scans_);
    for (uint64_t number = 1; number <= edits; ++number)
      statements.push_back(add_edit_row(record.id, number, forked.edits[number - 1], holding));
    const Status made = status_of(database.transact(statements));
    if (made.is_ok()) holdings.epochs[record.id] = holding.epoch;
    return made;
  };
  RETURN_IF_ERROR(queue_->run(fork, Repeat::kNever));
  if (has_same_cells(source, record)) paint_->copy(source.id, record.id);
  return emptied;
}

void PostgresJournal::append(const std::string& session_id, uint64_t first,
                             std::vector<AuthoredEdit> edits, Done done) {
  queue_->append({session_id, first, std::move(edits), std::move(done), {}});
}

Result<std::vector<AuthoredEdit>> PostgresJournal::edits(const std::string& session_id) {
  return read<std::vector<AuthoredEdit>>(
      [&](PgConnection& database) { return read_edit_rows(database, session_id); });
}

Result<uint64_t> PostgresJournal::edit_count(const std::string& session_id) {
  return read<uint64_t>([&](PgConnection& database) -> Result<uint64_t> {
    ASSIGN_OR_RETURN(const PgReply reply,
                     database.run({"SELECT edits FROM sessions WHERE id = $1", {session_id}}));
    return reply.rows() == 0 ? uint64_t{0} : static_cast<uint64_t>(reply.integer(0, 0));
  });
}

Result<SessionRoles> PostgresJournal::roles(const std::string& session_id) {
  return read<SessionRoles>(
      [&](PgConnection& database) { return read_role_rows(database, session_id); });
}

Status PostgresJournal::set_role(const std::string& session_id, const std::string& user,
                                 SessionRole role) {
  return queue_->run(
      [&](PgConnection& database, Holdings& holdings) {
        const PgStatement put = put_role_row(session_id, user, role, holdings.of(session_id));
        return change_held(database, put, session_id, holdings);
      },
      Repeat::kNever);
}

/// Enters the sessions within a transaction that has begun.
static Status enter_each(PgConnection& database, const NextSession& next) {
  for (;;) {
    ASSIGN_OR_RETURN(const auto session, next());
    if (!session) return Status::ok();
    const SessionRecord& record = session->record;
    for (const PgStatement& row : make_session_rows(record, session->roles, {}))
      RETURN_IF_ERROR(database.run(row).status());
    for (uint64_t number = 1; number <= session->edits.size(); ++number)
      RETURN_IF_ERROR(
          database.run(add_edit_row(record.id, number, session->edits[number - 1], {})).status());
  }
}

Status PostgresJournal::enter_all(const NextSession& next) {
  return queue_->run(
      [&](PgConnection& database, Holdings&) -> Status {
        RETURN_IF_ERROR(database.script("BEGIN"));
        const Status entered = enter_each(database, next);
        if (entered.is_ok()) return database.script("COMMIT");
        (void)database.script("ROLLBACK");
        return entered;
      },
      Repeat::kNever);
}

}  // namespace burnish
