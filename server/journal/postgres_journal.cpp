#include "server/journal/postgres_journal.h"

#include <algorithm>
#include <optional>

#include <spdlog/spdlog.h>

#include "server/journal/forked_edits.h"
#include "server/journal/postgres_holding.h"

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

Result<uint64_t> PostgresJournal::history_bytes(const std::string& session_id) {
  return read<uint64_t>([&](PgConnection& database) -> Result<uint64_t> {
    ASSIGN_OR_RETURN(const PgReply reply,
                     database.run({"SELECT COALESCE(SUM(LENGTH(bytes) + LENGTH(author) +"
                                   " LENGTH(id) + $2), 0)::bigint FROM edits WHERE session_id = $1",
                                   {session_id, static_cast<int64_t>(kHistoryBytesOfARow)}}));
    return static_cast<uint64_t>(reply.integer(0, 0));
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
