#include "server/session/journal.h"

#include <spdlog/spdlog.h>

#include "common/wire/edit_bytes.h"
#include "server/session/journal_schema.h"

namespace burnish {

Result<std::unique_ptr<Journal>> Journal::open(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(Database database, Database::open(path));
  RETURN_IF_ERROR(make_journal_schema(database).with_context(path.string()));
  return std::unique_ptr<Journal>(new Journal(std::move(database)));
}

namespace {

/// Prepares, binds and runs a statement without rows.
template <typename... Values>
Status run(Database& database, const char* sql, const Values&... values) {
  ASSIGN_OR_RETURN(Statement statement, database.prepare(sql));
  return statement.bind(values...).run();
}

/// Prepares, binds and calls `take` for every row.
template <typename Take, typename... Values>
Status read_rows(Database& database, const char* sql, const Take& take, const Values&... values) {
  ASSIGN_OR_RETURN(Statement query, database.prepare(sql));
  query.bind(values...);
  for (;;) {
    ASSIGN_OR_RETURN(const bool row, query.step());
    if (!row) return Status::ok();
    RETURN_IF_ERROR(take(query));
  }
}

Status insert_session(Database& database, const SessionRecord& record, const SessionRoles& roles) {
  RETURN_IF_ERROR(run(database, "INSERT INTO sessions VALUES (?, ?, ?, ?, ?, ?)", record.id,
                      record.name, record.scan_id, int64_t{record.key.depth},
                      record.key.curvature_radius, record.created_unix_seconds));
  for (const auto& [user, role] : roles.by_user())
    RETURN_IF_ERROR(run(database, "INSERT INTO roles VALUES (?, ?, ?)", record.id, user,
                        static_cast<int64_t>(role)));
  return Status::ok();
}

Result<uint64_t> last_number(Database& database, const std::string& session_id) {
  ASSIGN_OR_RETURN(Statement query,
                   database.prepare("SELECT MAX(number) FROM edits WHERE session_id = ?"));
  RETURN_IF_ERROR(query.bind(session_id).run());
  return static_cast<uint64_t>(query.integer(0));
}

Status insert_edits(Database& database, const std::string& session_id, uint64_t first,
                    const std::vector<AuthoredEdit>& edits) {
  ASSIGN_OR_RETURN(const uint64_t last, last_number(database, session_id));
  if (last + 1 != first)
    return data_loss("the session's edits end at " + std::to_string(last) + ", not before " +
                     std::to_string(first) + ": some could not be written");
  for (size_t i = 0; i < edits.size(); ++i)
    RETURN_IF_ERROR(run(database, "INSERT INTO edits VALUES (?, ?, ?, ?, ?, ?)", session_id,
                        static_cast<int64_t>(first + i), edits[i].author, edits[i].edit.id,
                        edits[i].unix_ms, edit_to_bytes(edits[i].edit)));
  return Status::ok();
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

Result<std::vector<SessionRecord>> Journal::sessions() {
  std::vector<SessionRecord> records;
  const auto take = [&](const Statement& row) {
    records.push_back({row.text(0),
                       row.text(1),
                       row.text(2),
                       {static_cast<int>(row.integer(3)), row.real(4)},
                       row.integer(5)});
    return Status::ok();
  };
  RETURN_IF_ERROR(commit_.read([&](Database& database) {
    return read_rows(database,
                     "SELECT id, name, scan_id, depth, curvature_radius, created_unix_seconds"
                     " FROM sessions ORDER BY name",
                     take);
  }));
  return records;
}

Status Journal::create_session(const SessionRecord& record, const SessionRoles& roles) {
  return commit_.write([&](Database& database) { return insert_session(database, record, roles); });
}

Status Journal::remove_session(const std::string& id) {
  return commit_.write(
      [&](Database& database) { return run(database, "DELETE FROM sessions WHERE id = ?", id); });
}

Status Journal::fork_session(const std::string& source_id, uint64_t edits,
                             const SessionRecord& record, const SessionRoles& roles) {
  return commit_.write([&](Database& database) -> Status {
    ASSIGN_OR_RETURN(const uint64_t last, last_number(database, source_id));
    if (last < edits)
      return data_loss("the session's edits end at " + std::to_string(last) + ", not at " +
                       std::to_string(edits) + ": some could not be written");
    RETURN_IF_ERROR(insert_session(database, record, roles));
    RETURN_IF_ERROR(run(database,
                        "INSERT INTO edits SELECT ?, number, author, id, unix_ms, bytes"
                        " FROM edits WHERE session_id = ? AND number <= ? ORDER BY number",
                        record.id, source_id, static_cast<int64_t>(edits)));
    return run(database,
               "INSERT INTO paint (session_id, series, strokes, bytes)"
               " SELECT ?, series, strokes, bytes FROM paint WHERE session_id = ?"
               " ORDER BY sequence",
               record.id, source_id);
  });
}

void Journal::append(const std::string& session_id, uint64_t first, std::vector<AuthoredEdit> edits,
                     GroupCommit::Done done) {
  commit_.post([session_id, first, edits = std::move(edits)](
                   Database& database) { return insert_edits(database, session_id, first, edits); },
               std::move(done));
}

Status Journal::append(const std::string& session_id, uint64_t first,
                       std::vector<AuthoredEdit> edits) {
  return commit_.write(
      [&](Database& database) { return insert_edits(database, session_id, first, edits); });
}

Result<std::vector<AuthoredEdit>> Journal::edits(const std::string& session_id) {
  std::vector<AuthoredEdit> edits;
  const auto take = [&](const Statement& row) -> Status {
    ASSIGN_OR_RETURN(Edit edit, edit_from_bytes(row.text(2)));
    edits.push_back({row.text(0), row.integer(1), std::move(edit)});
    return Status::ok();
  };
  RETURN_IF_ERROR(commit_.read([&](Database& database) {
    return read_rows(
        database, "SELECT author, unix_ms, bytes FROM edits WHERE session_id = ? ORDER BY number",
        take, session_id);
  }));
  return edits;
}

Result<uint64_t> Journal::edit_count(const std::string& session_id) {
  uint64_t count = 0;
  RETURN_IF_ERROR(commit_.read([&](Database& database) -> Status {
    ASSIGN_OR_RETURN(count, last_number(database, session_id));
    return Status::ok();
  }));
  return count;
}

Result<SessionRoles> Journal::roles(const std::string& session_id) {
  std::map<std::string, SessionRole> roles;
  const auto take = [&](const Statement& row) {
    roles[row.text(0)] = static_cast<SessionRole>(row.integer(1));
    return Status::ok();
  };
  RETURN_IF_ERROR(commit_.read([&](Database& database) {
    return read_rows(database, "SELECT user, role FROM roles WHERE session_id = ?", take,
                     session_id);
  }));
  return SessionRoles(std::move(roles));
}

Status Journal::set_role(const std::string& session_id, const std::string& user, SessionRole role) {
  return commit_.write([&](Database& database) {
    return run(database, "INSERT OR REPLACE INTO roles VALUES (?, ?, ?)", session_id, user,
               static_cast<int64_t>(role));
  });
}

void Journal::keep_paint(const std::string& session_id, const PaintCheckpoint& paint) {
  commit_.post(
      [session_id, series = static_cast<int64_t>(paint.series),
       strokes = static_cast<int64_t>(paint.strokes),
       bytes = painted_to_bytes(paint.painted)](Database& database) {
        return insert_paint(database, session_id, series, strokes, bytes);
      },
      [session_id](const Status& status) {
        if (!status.is_ok())
          spdlog::warn("session {}: its paint is not kept: {}", session_id, status.message());
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
