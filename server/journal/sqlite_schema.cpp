#include "server/journal/sqlite_schema.h"

#include <array>

namespace burnish {

// Step n brings a journal from version n to n + 1. A released step never changes.
static constexpr std::array kSteps = {
    R"sql(
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
)sql",
    // Edits get a number in their session, an author and a time; sessions get roles and paint. Old
    // sessions have no owner: everybody is one. `user` x'' stands for everybody else.
    R"sql(
  ALTER TABLE edits RENAME TO old_edits;
  CREATE TABLE edits (
    session_id BLOB NOT NULL REFERENCES sessions(id) ON DELETE CASCADE,
    number INTEGER NOT NULL, author BLOB NOT NULL, id BLOB NOT NULL,
    unix_ms INTEGER NOT NULL, bytes BLOB NOT NULL,
    UNIQUE (session_id, number), UNIQUE (session_id, author, id)
  );
  INSERT INTO edits
    SELECT session_id, ROW_NUMBER() OVER (PARTITION BY session_id ORDER BY sequence), x'',
           old_edits.id, 1000 * created_unix_seconds, bytes
    FROM old_edits JOIN sessions ON sessions.id = session_id ORDER BY sequence;
  DROP TABLE old_edits;
  CREATE TABLE roles (
    session_id BLOB NOT NULL REFERENCES sessions(id) ON DELETE CASCADE,
    user BLOB NOT NULL, role INTEGER NOT NULL, PRIMARY KEY (session_id, user)
  ) WITHOUT ROWID;
  INSERT INTO roles SELECT id, x'', 3 FROM sessions;
  CREATE TABLE paint (
    sequence INTEGER PRIMARY KEY AUTOINCREMENT,
    session_id BLOB NOT NULL REFERENCES sessions(id) ON DELETE CASCADE,
    series INTEGER NOT NULL, strokes INTEGER NOT NULL, bytes BLOB NOT NULL,
    UNIQUE (session_id, series)
  );
  PRAGMA user_version = 2;
)sql",
    // Rows get checksums, and sessions the number of their last edit, so that a changed, swapped or
    // lost row is found. A row with `checksum` x'' is known to be damaged.
    R"sql(
  ALTER TABLE sessions ADD COLUMN checksum BLOB NOT NULL DEFAULT x'';
  ALTER TABLE edits ADD COLUMN checksum BLOB NOT NULL DEFAULT x'';
  ALTER TABLE roles ADD COLUMN checksum BLOB NOT NULL DEFAULT x'';
  UPDATE sessions SET checksum =
    row_checksum(id, name, scan_id, depth, curvature_radius, created_unix_seconds);
  UPDATE edits SET checksum = row_checksum(session_id, number, author, id, unix_ms, bytes);
  UPDATE roles SET checksum = row_checksum(session_id, user, role);
  CREATE TABLE ends (
    session_id BLOB PRIMARY KEY REFERENCES sessions(id) ON DELETE CASCADE,
    number INTEGER NOT NULL, checksum BLOB NOT NULL
  ) WITHOUT ROWID;
  INSERT INTO ends SELECT id, number, row_checksum(id, number) FROM (
    SELECT id, IFNULL((SELECT MAX(number) FROM edits WHERE session_id = sessions.id), 0) AS number
    FROM sessions);
  PRAGMA user_version = 3;
)sql",
    // Sessions get their initial controls; old ones have none. A damaged row stays
    // damaged.
    R"sql(
  ALTER TABLE sessions ADD COLUMN pins_rims INTEGER NOT NULL DEFAULT 0;
  UPDATE sessions SET checksum =
    row_checksum(id, name, scan_id, depth, curvature_radius, created_unix_seconds, pins_rims)
    WHERE checksum =
      row_checksum(id, name, scan_id, depth, curvature_radius, created_unix_seconds);
  PRAGMA user_version = 4;
)sql",
    // Edits may set bands and a palette, and paint them. A program of version 4 would lose these.
    "PRAGMA user_version = 5;",
    // Edits may filter and paint colours.
    "PRAGMA user_version = 6;",
    // Sessions get their maker, with a checksum of its own as in PostgreSQL. Both are x'' where
    // nobody knows the maker.
    R"sql(
  ALTER TABLE sessions ADD COLUMN maker BLOB NOT NULL DEFAULT x'';
  ALTER TABLE sessions ADD COLUMN maker_checksum BLOB NOT NULL DEFAULT x'';
  PRAGMA user_version = 7;
)sql"};

static Result<int64_t> number(Database& database, const char* sql) {
  ASSIGN_OR_RETURN(Statement query, database.prepare(sql));
  RETURN_IF_ERROR(query.run());
  return query.integer(0);
}

Result<bool> has_journal_schema(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(Database database, Database::open_as_it_is(path));
  ASSIGN_OR_RETURN(const int64_t version, number(database, "PRAGMA user_version"));
  return version != 0;
}

Status make_journal_schema(Database& database) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::begin(database));
  ASSIGN_OR_RETURN(int64_t version, number(database, "PRAGMA user_version"));
  ASSIGN_OR_RETURN(const int64_t objects, number(database, "SELECT COUNT(*) FROM sqlite_schema"));
  if (version == 0 && objects > 0) return data_loss("it is a database of another program");
  const auto newest = static_cast<int64_t>(kSteps.size());
  if (version < 0 || version > newest)
    return data_loss("its version is " + std::to_string(version) + ", this program knows " +
                     std::to_string(newest) + ": a later program has written it");
  for (; version < newest; ++version)
    RETURN_IF_ERROR(database.execute(kSteps[static_cast<size_t>(version)]));
  return transaction.commit().status();
}

}  // namespace burnish
