#include "server/session/journal.h"

#include "common/wire/edit_bytes.h"

namespace burnish {

static constexpr int64_t kSchemaVersion = 1;

static constexpr char kSchema[] = R"sql(
  CREATE TABLE sessions (
    id BLOB PRIMARY KEY, name BLOB NOT NULL UNIQUE, scan_id BLOB NOT NULL,
    depth INTEGER NOT NULL, curvature_radius REAL NOT NULL, created_unix_seconds INTEGER NOT NULL
  ) WITHOUT ROWID;
  CREATE TABLE edits (
    sequence INTEGER PRIMARY KEY AUTOINCREMENT,
    session_id BLOB NOT NULL REFERENCES sessions(id) ON DELETE CASCADE,
    id BLOB NOT NULL, bytes BLOB NOT NULL, UNIQUE (session_id, id)
  );
  PRAGMA user_version = 1;
)sql";

static Status make_schema(Database& database) {
  ASSIGN_OR_RETURN(Statement query, database.prepare("PRAGMA user_version"));
  RETURN_IF_ERROR(query.run());
  const int64_t version = query.integer(0);
  if (version == kSchemaVersion) return Status::ok();
  if (version != 0)
    return data_loss("its version is " + std::to_string(version) + ", this program knows " +
                     std::to_string(kSchemaVersion));
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::begin(database));
  RETURN_IF_ERROR(database.execute(kSchema));
  return transaction.commit();
}

Result<std::unique_ptr<Journal>> Journal::open(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(Database database, Database::open(path));
  RETURN_IF_ERROR(make_schema(database).with_context(path.string()));
  return std::unique_ptr<Journal>(new Journal(std::move(database)));
}

Result<std::vector<SessionRecord>> Journal::sessions() {
  const std::lock_guard lock(mutex_);
  ASSIGN_OR_RETURN(Statement query,
                   database_.prepare("SELECT id, name, scan_id, depth, curvature_radius,"
                                     " created_unix_seconds FROM sessions ORDER BY name"));
  std::vector<SessionRecord> records;
  for (;;) {
    ASSIGN_OR_RETURN(const bool row, query.step());
    if (!row) return records;
    records.push_back({query.text(0),
                       query.text(1),
                       query.text(2),
                       {static_cast<int>(query.integer(3)), query.real(4)},
                       query.integer(5)});
  }
}

Status Journal::create_session(const SessionRecord& record) {
  const std::lock_guard lock(mutex_);
  ASSIGN_OR_RETURN(Statement insert,
                   database_.prepare("INSERT INTO sessions VALUES (?, ?, ?, ?, ?, ?)"));
  return insert
      .bind(record.id, record.name, record.scan_id, int64_t{record.key.depth},
            record.key.curvature_radius, record.created_unix_seconds)
      .run();
}

Status Journal::remove_session(const std::string& id) {
  const std::lock_guard lock(mutex_);
  ASSIGN_OR_RETURN(Statement remove, database_.prepare("DELETE FROM sessions WHERE id = ?"));
  return remove.bind(id).run();
}

Status Journal::append(const std::string& session_id, std::span<const Edit> edits) {
  const std::lock_guard lock(mutex_);
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::begin(database_));
  for (const Edit& edit : edits) {
    ASSIGN_OR_RETURN(
        Statement insert,
        database_.prepare("INSERT INTO edits (session_id, id, bytes) VALUES (?, ?, ?)"));
    RETURN_IF_ERROR(insert.bind(session_id, edit.id, edit_to_bytes(edit)).run());
  }
  return transaction.commit();
}

Result<std::vector<Edit>> Journal::edits(const std::string& session_id) {
  const std::lock_guard lock(mutex_);
  ASSIGN_OR_RETURN(
      Statement query,
      database_.prepare("SELECT bytes FROM edits WHERE session_id = ? ORDER BY sequence"));
  query.bind(session_id);
  std::vector<Edit> edits;
  for (;;) {
    ASSIGN_OR_RETURN(const bool row, query.step());
    if (!row) return edits;
    ASSIGN_OR_RETURN(Edit edit, edit_from_bytes(query.text(0)));
    edits.push_back(std::move(edit));
  }
}

Result<uint64_t> Journal::edit_count(const std::string& session_id) {
  const std::lock_guard lock(mutex_);
  ASSIGN_OR_RETURN(Statement query,
                   database_.prepare("SELECT COUNT(*) FROM edits WHERE session_id = ?"));
  RETURN_IF_ERROR(query.bind(session_id).run());
  return static_cast<uint64_t>(query.integer(0));
}

}  // namespace burnish
