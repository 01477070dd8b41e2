#include "server/journal/postgres_appends.h"

#include "server/journal/damaged_edits.h"
#include "server/journal/postgres_holding.h"
#include "server/metrics/metrics.h"

namespace burnish {
namespace {

/// Asks whether the session is held, and ends before `number`.
PgStatement ask_for_end(const std::string& session_id, uint64_t number, const Holding& holding) {
  return {
      "SELECT id FROM sessions WHERE id = $1 AND edits = $2 - 1 AND epoch = $4"
      " AND owner IS NOT DISTINCT FROM CAST(NULLIF($3, '') AS uuid)",
      {session_id, static_cast<int64_t>(number), PgText{holding.life}, holding.epoch}};
}

void add_statements(const PendingAppend& append, const Holding& holding,
                    std::vector<PgStatement>& statements) {
  if (append.edits.empty())
    statements.push_back(ask_for_end(append.session_id, append.first, holding));
  for (size_t i = 0; i < append.edits.size(); ++i)
    statements.push_back(
        add_edit_row(append.session_id, append.first + i, append.edits[i], holding));
}

size_t statement_count(const PendingAppend& append) {
  return std::max<size_t>(1, append.edits.size());
}

/// Returns whether the rows are these very edits.
bool are_rows_of(const PgReply& rows, const PendingAppend& append) {
  if (append.edits.empty() || rows.rows() != append.edits.size()) return false;
  for (size_t i = 0; i < append.edits.size(); ++i) {
    const AuthoredEdit& edit = append.edits[i];
    const bool is_damaged = kind_of(edit.edit) == EditKind::kDamaged;
    const std::string id = is_damaged ? id_of_damaged(append.first + i) : edit.edit.id;
    if (rows.bytes(i, 0) != edit.author || rows.bytes(i, 1) != id) return false;
  }
  return true;
}

/// Finds out why an append has changed nothing. It may have been written before, unheard. Its rows
/// may be seen before a standby has them. The update is in the log behind them, so its commit waits
/// for them.
std::vector<PgStatement> ask_for_reasons(const PendingAppend& append, const Holding& holding) {
  const auto first = static_cast<int64_t>(append.first);
  const auto count = static_cast<int64_t>(append.edits.size());
  return {{"SELECT author, id FROM edits WHERE session_id = $1 AND epoch = $2"
           " AND number BETWEEN $3 AND $4 ORDER BY number",
           {append.session_id, holding.epoch, first, first + count - 1}},
          {"UPDATE sessions SET edits = edits WHERE id = $1 RETURNING edits, epoch = $2"
           " AND owner IS NOT DISTINCT FROM CAST(NULLIF($3, '') AS uuid)",
           {append.session_id, holding.epoch, PgText{holding.life}}}};
}

Result<WriteOutcome> examine(PgConnection& database, const PendingAppend& append,
                             const Holdings& holdings) {
  const Holding holding = holdings.of(append.session_id);
  const PgOutcome asked = database.transact(ask_for_reasons(append, holding));
  RETURN_IF_ERROR(asked.why);
  if (are_rows_of(asked.replies[0], append)) return WriteOutcome();
  const PgReply& session = asked.replies[1];
  if (session.rows() == 0)
    return WriteOutcome::refused(not_found("no session has the id '" + append.session_id + "'"));
  if (session.integer(0, 1) == 0) {
    metrics().add(Count::kFencedAppends, 1);
    const Status holder = who_holds(database, append.session_id, holdings);
    if (!holder.moved_to().empty()) return WriteOutcome::unknown(holder);
    return WriteOutcome::unknown(
        failed_precondition("this server does not hold the session any more"));
  }
  return WriteOutcome::refused(data_loss(
      "the session's edits end at " + std::to_string(session.integer(0, 0)) + "; the next one is " +
      std::to_string(append.first) + ", so some were not written"));
}

PgOutcome write_together(PgConnection& database, const Holdings& holdings,
                         std::span<PendingAppend> appends) {
  std::vector<PgStatement> statements;
  for (const PendingAppend& append : appends)
    add_statements(append, holdings.of(append.session_id), statements);
  return database.transact(statements);
}

/// Reads the outcome of each append of a transaction that was committed.
Status take_outcomes(PgConnection& database, const Holdings& holdings,
                     const std::vector<PgReply>& replies, std::span<PendingAppend> appends) {
  Status problem;
  size_t next = 0;
  for (PendingAppend& append : appends) {
    // All of its statements change a row, or none.
    const bool has_changed = replies[next].affected() > 0;
    next += statement_count(append);
    if (has_changed) {
      append.outcome = WriteOutcome();
      continue;
    }
    const auto found = examine(database, append, holdings);
    if (found.is_ok()) {
      append.outcome = *found;
    } else {
      problem = found.status();
    }
  }
  return problem;
}

Status write_alone(PgConnection& database, const Holdings& holdings,
                   std::span<PendingAppend> appends) {
  Status problem;
  for (size_t i = 0; i < appends.size(); ++i) {
    const Status status = write_appends(database, holdings, appends.subspan(i, 1));
    if (!status.is_ok()) problem = status;
  }
  return problem;
}

}  // namespace

Status write_appends(PgConnection& database, const Holdings& holdings,
                     std::span<PendingAppend> appends) {
  const PgOutcome together = write_together(database, holdings, appends);
  if (together.end == PgOutcome::End::kCommitted)
    return take_outcomes(database, holdings, together.replies, appends);
  if (together.end == PgOutcome::End::kUnknown || !database.is_open()) return together.why;
  if (appends.size() > 1) return write_alone(database, holdings, appends);
  if (together.why.code() == StatusCode::kUnavailable) return together.why;
  appends.front().outcome = WriteOutcome::refused(together.why);
  return Status::ok();
}

}  // namespace burnish
