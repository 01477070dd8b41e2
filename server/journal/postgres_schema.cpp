#include "server/journal/postgres_schema.h"

#include <array>

namespace burnish {

// Step n brings a journal from version n to n + 1. A released step never changes. Steps only add:
// the program before this one goes on with the new schema while servers are exchanged.
static constexpr std::array kPgSteps = {
    // A life of a node is one run of one server. `edits` is the number of the session's last edit;
    // appends compare it, the owner and the epoch. Half of each page of sessions stays free, so
    // that
    // an append's update touches no index.
    R"sql(
  CREATE TABLE nodes (
    id uuid PRIMARY KEY, name text NOT NULL UNIQUE, address text NOT NULL,
    lease_until timestamptz NOT NULL, draining boolean NOT NULL DEFAULT false,
    backend text NOT NULL DEFAULT '', bytes_max bigint NOT NULL DEFAULT 0,
    bytes_taken bigint NOT NULL DEFAULT 0, sessions bigint NOT NULL DEFAULT 0
  );
  CREATE TABLE sessions (
    id bytea PRIMARY KEY, name bytea NOT NULL UNIQUE, scan_id bytea NOT NULL,
    depth bigint NOT NULL, curvature_radius double precision NOT NULL,
    created_unix_seconds bigint NOT NULL, pins_rims bigint NOT NULL, checksum bytea NOT NULL,
    edits bigint NOT NULL DEFAULT 0,
    owner uuid REFERENCES nodes ON DELETE SET NULL, epoch bigint NOT NULL DEFAULT 0
  ) WITH (fillfactor = 50);
  CREATE INDEX sessions_of_owner ON sessions (owner);
  CREATE TABLE edits (
    session_id bytea NOT NULL REFERENCES sessions ON DELETE CASCADE, number bigint NOT NULL,
    epoch bigint NOT NULL, author bytea NOT NULL, id bytea NOT NULL, unix_ms bigint NOT NULL,
    bytes bytea NOT NULL, checksum bytea NOT NULL,
    PRIMARY KEY (session_id, number), UNIQUE (session_id, author, id)
  );
  CREATE TABLE roles (
    session_id bytea NOT NULL REFERENCES sessions ON DELETE CASCADE, "user" bytea NOT NULL,
    role bigint NOT NULL, checksum bytea NOT NULL, PRIMARY KEY (session_id, "user")
  );
)sql",
    // The catalogue of scans in a shared folder. A scan's version changes whenever the scan does.
    // `shared_scan` is null for a session whose scan is in its servers' own folders.
    R"sql(
  CREATE SEQUENCE scan_versions;
  CREATE TABLE scans (
    id bytea PRIMARY KEY, info bytea NOT NULL,
    version bigint NOT NULL DEFAULT nextval('scan_versions')
  );
  ALTER TABLE sessions ADD COLUMN shared_scan bytea REFERENCES scans;
)sql",
    // Who has brought a session into the memory of its owner; null: nobody who is counted.
    R"sql(
  ALTER TABLE sessions ADD COLUMN held_for bytea;
)sql",
    // Who made a session. The program before this one leaves both empty, and reads a checksum that
    // does not know of them.
    R"sql(
  ALTER TABLE sessions ADD COLUMN maker bytea NOT NULL DEFAULT '',
    ADD COLUMN maker_checksum bytea NOT NULL DEFAULT '';
)sql"};

static Status lock_version(PgConnection& database) {
  return database.script(
      "BEGIN; SET LOCAL lock_timeout = '4s';"
      "CREATE SCHEMA IF NOT EXISTS burnish;"
      "CREATE TABLE IF NOT EXISTS version (number bigint NOT NULL);"
      "LOCK TABLE version IN ACCESS EXCLUSIVE MODE");
}

static Result<int64_t> read_version(PgConnection& database) {
  ASSIGN_OR_RETURN(const PgReply reply, database.run({"SELECT max(number) FROM version", {}}));
  return reply.bytes(0, 0).empty() ? 0 : reply.integer(0, 0);
}

static Status migrate(PgConnection& database) {
  ASSIGN_OR_RETURN(const int64_t found, read_version(database));
  const auto newest = static_cast<int64_t>(kPgSteps.size());
  if (found < 0 || found > newest + 1)
    return data_loss("the journal's version is " + std::to_string(found) + ", this program knows " +
                     std::to_string(newest) + " and takes " + std::to_string(newest + 1) +
                     ": a later program has written it; use that one, or a backup");
  for (int64_t version = found; version < newest; ++version)
    RETURN_IF_ERROR(database.script(kPgSteps[static_cast<size_t>(version)]));
  if (found >= newest) return Status::ok();
  RETURN_IF_ERROR(database.script("DELETE FROM version"));
  return database.run({"INSERT INTO version VALUES ($1)", {newest}}).status();
}

Status make_postgres_schema(PgConnection& database) {
  // If two servers make the same table at once, one fails, and finds it at its next try.
  static constexpr int kTries = 3;
  Status status;
  for (int i = 0; i < kTries; ++i) {
    status = lock_version(database);
    if (status.is_ok()) status = migrate(database);
    if (status.is_ok()) return database.script("COMMIT");
    (void)database.script("ROLLBACK");
    if (status.code() != StatusCode::kAlreadyExists) break;
  }
  return status;
}

}  // namespace burnish
