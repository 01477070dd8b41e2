#include "server/journal/journal.h"

#include <future>
#include <map>
#include <optional>

#include <spdlog/spdlog.h>

#include "server/journal/journal_rows.h"
#include "server/journal/journal_schema.h"

namespace burnish {

/// Turns edits that the write-ahead log has lost into missing edits: clients know their numbers.
/// Returns the last number of each session.
static Result<std::map<std::string, uint64_t>> compare_ends(Database& database,
                                                            const JournalEnds& seen) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::begin(database));
  ASSIGN_OR_RETURN(const auto sessions, read_sessions(database));
  std::map<std::string, uint64_t> ends;
  for (const SessionRecord& session : sessions) {
    ASSIGN_OR_RETURN(ends[session.id], last_number(database, session.id));
  }
  for (const auto& [id, number] : seen.read()) {
    const auto end = ends.find(id);
    if (end == ends.end()) {
      spdlog::error("session {} with {} edits is missing from the journal", id, number);
    } else if (end->second < number) {
      spdlog::error("session {}: the journal ends at edit {}, but it had reached edit {} before",
                    id, end->second, number);
      RETURN_IF_ERROR(set_last_number(database, id, number));
      end->second = number;
    }
  }
  RETURN_IF_ERROR(transaction.commit());
  return ends;
}

Result<std::unique_ptr<Journal>> Journal::open(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(Database database, Database::open(path));
  RETURN_IF_ERROR(make_journal_schema(database).with_context(path.string()));
  ASSIGN_OR_RETURN(const auto users, read_users_of_damaged_roles(database));
  for (const std::string& user : users)
    spdlog::error("a role of user '{}' in the journal is damaged", user);
  auto ends_path = path;
  auto ends = std::make_unique<JournalEnds>(ends_path.replace_extension(".ends"));
  const auto now = compare_ends(database, *ends);
  RETURN_IF_ERROR(now.status().with_context(path.string()));
  ends->begin(*now);
  return std::unique_ptr<Journal>(new Journal(std::move(database), std::move(ends)));
}

namespace {

Result<int64_t> free_pages(Database& database) {
  ASSIGN_OR_RETURN(Statement query, database.prepare("PRAGMA freelist_count"));
  RETURN_IF_ERROR(query.run());
  return query.integer(0);
}

Status insert_paint(Database& database, const std::string& session_id, int64_t series,
                    int64_t strokes, const std::string& bytes) {
  RETURN_IF_ERROR(run(database,
                      "INSERT OR REPLACE INTO paint (session_id, series, strokes, bytes)"
                      " VALUES (?, ?, ?, ?)",
                      session_id, series, strokes, bytes));
  return run(database,
             "DELETE FROM paint WHERE session_id = ?1 AND sequence NOT IN"
             " (SELECT sequence FROM paint WHERE session_id = ?1 ORDER BY sequence DESC LIMIT 8)",
             session_id);
}

}  // namespace

template <typename T>
Result<T> Journal::read(const std::function<Result<T>(Database&)>& work) {
  std::optional<Result<T>> result;
  RETURN_IF_ERROR(commit_.read([&](Database& database) {
    result = work(database);
    return Status::ok();
  }));
  return std::move(*result);
}

Result<std::vector<SessionRecord>> Journal::sessions() {
  ASSIGN_OR_RETURN(auto records, read<std::vector<SessionRecord>>(read_sessions));
  for (const SessionRecord& record : records)
    if (record.is_damaged)
      spdlog::error("session {} ({}): its row in the journal is damaged", record.id, record.name);
  return records;
}

Status Journal::create_session(const SessionRecord& record, const SessionRoles& roles) {
  return commit_.write([&](Database& database) { return insert_session(database, record, roles); });
}

Status Journal::rename_session(const std::string& id, const std::string& name) {
  return commit_.write(
      [&](Database& database) { return burnish::rename_session(database, id, name); });
}

Status Journal::remove_session(const std::string& id) {
  RETURN_IF_ERROR(commit_.write(
      [&](Database& database) { return run(database, "DELETE FROM sessions WHERE id = ?", id); }));
  ends_->forget(id);
  shrink();
  return Status::ok();
}

void Journal::shrink() {
  const auto left = std::make_shared<int64_t>(0);
  commit_.post_background(
      [left](Database& database) -> Status {
        ASSIGN_OR_RETURN(const int64_t before, free_pages(database));
        RETURN_IF_ERROR(database.execute("PRAGMA incremental_vacuum(256)"));
        ASSIGN_OR_RETURN(const int64_t after, free_pages(database));
        *left = after < before ? after : 0;  // an old journal cannot shrink
        return Status::ok();
      },
      [this, left](const Status& status) {
        if (status.is_ok() && *left > 0 && !ending_) shrink();
      });
}

/// Returns how many edits set cells before.
static uint64_t empty_cell_fields(std::vector<AuthoredEdit>& edits) {
  uint64_t emptied = 0;
  for (AuthoredEdit& each : edits) {
    auto* fields = std::get_if<SetCellFields>(&each.edit.change);
    if (fields == nullptr || fields->cells.empty()) continue;
    fields->cells.clear();
    ++emptied;
  }
  return emptied;
}

static Status copy_paint(Database& database, const SessionRecord& from, const SessionRecord& to) {
  return run(database,
             "INSERT INTO paint (session_id, series, strokes, bytes)"
             " SELECT ?, series, strokes, bytes FROM paint WHERE session_id = ?"
             " ORDER BY sequence",
             to.id, from.id);
}

Result<uint64_t> Journal::fork_session(const SessionRecord& source, uint64_t edits,
                                       const SessionRecord& record, const SessionRoles& roles) {
  const bool has_same_cells = source.key.depth == record.key.depth;
  uint64_t emptied = 0;
  const Status status = commit_.write([&](Database& database) -> Status {
    ASSIGN_OR_RETURN(std::vector<AuthoredEdit> copied, read_edits(database, source.id));
    if (copied.size() < edits)
      return data_loss("the session's edits end at " + std::to_string(copied.size()) + ", not at " +
                       std::to_string(edits) + "; some were not written");
    copied.resize(edits);
    if (!has_same_cells) emptied = empty_cell_fields(copied);
    RETURN_IF_ERROR(insert_session(database, record, roles));
    RETURN_IF_ERROR(insert_edits(database, record.id, 1, copied));
    return has_same_cells ? copy_paint(database, source, record) : Status::ok();
  });
  RETURN_IF_ERROR(status);
  ends_->note(record.id, edits);
  return emptied;
}

void Journal::append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits,
                     GroupCommit::Done done) {
  const uint64_t last = first + edits.size() - 1;
  commit_.post([session_id, first, edits = std::move(edits)](
                   Database& database) { return insert_edits(database, session_id, first, edits); },
               [this, session_id, last, done = std::move(done)](const Status& status) {
                 if (status.is_ok()) ends_->note(session_id, last);
                 done(status);
               });
}

Status Journal::append(const std::string& session_id, uint64_t first,
                       std::vector<AuthoredEdit> edits) {
  std::promise<Status> written;
  append(session_id, first, std::move(edits),
         [&](const Status& status) { written.set_value(status); });
  return written.get_future().get();
}

Result<std::vector<AuthoredEdit>> Journal::edits(const std::string& session_id) {
  return read<std::vector<AuthoredEdit>>(
      [&](Database& database) { return read_edits(database, session_id); });
}

Result<uint64_t> Journal::edit_count(const std::string& session_id) {
  return read<uint64_t>([&](Database& database) { return last_number(database, session_id); });
}

Result<uint64_t> Journal::checkpoint(const std::string& session_id, const std::string& name) {
  ASSIGN_OR_RETURN(const auto edits, this->edits(session_id));
  for (size_t number = edits.size(); number > 0; --number) {
    const auto* change = std::get_if<SetCheckpoint>(&edits[number - 1].edit.change);
    if (change && change->name == name) return uint64_t{number};
  }
  return not_found("no checkpoint has the name '" + name + "'");
}

Result<SessionRoles> Journal::roles(const std::string& session_id) {
  return read<SessionRoles>([&](Database& database) -> Result<SessionRoles> {
    ASSIGN_OR_RETURN(const auto damaged, read_users_of_damaged_roles(database));
    return read_roles(database, session_id, damaged);
  });
}

Status Journal::set_role(const std::string& session_id, const std::string& user, SessionRole role) {
  return commit_.write(
      [&](Database& database) { return insert_role(database, session_id, user, role); });
}

void Journal::keep_paint(const std::string& session_id, const PaintCheckpoint& paint) {
  commit_.post_background(
      [session_id, series = static_cast<int64_t>(paint.series),
       strokes = static_cast<int64_t>(paint.strokes),
       bytes = painted_to_bytes(paint.painted)](Database& database) {
        return insert_paint(database, session_id, series, strokes, bytes);
      },
      [session_id](const Status& status) {
        if (!status.is_ok())
          spdlog::warn("session {}: cannot keep its paint: {}", session_id, status.message());
      });
}

Result<std::vector<PaintCheckpoint>> Journal::paint(const std::string& session_id,
                                                    size_t cell_count) {
  std::vector<PaintCheckpoint> kept;
  const auto take = [&](const Statement& row) {
    auto painted = painted_from_bytes(row.text(2), cell_count);
    if (painted.is_ok()) {
      kept.push_back({static_cast<uint64_t>(row.integer(0)), static_cast<uint64_t>(row.integer(1)),
                      std::move(*painted)});
    } else {
      spdlog::warn("session {}: {}", session_id, painted.status().message());
    }
    return Status::ok();
  };
  RETURN_IF_ERROR(commit_.read([&](Database& database) {
    return read_rows(
        database, "SELECT series, strokes, bytes FROM paint WHERE session_id = ? ORDER BY sequence",
        take, session_id);
  }));
  return kept;
}

}  // namespace burnish
