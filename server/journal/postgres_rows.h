#pragma once

#include <string>
#include <vector>

#include "server/journal/journal.h"
#include "server/postgres/pg_connection.h"

namespace burnish {

// The rows of a PostgreSQL journal, each with the checksum that SQLite's journal gives it. Text
// comes back as valid UTF-8, whatever it was.

/// Which life of which node holds a session.
struct Holding {
  std::string life;  ///< id of the life, as text; empty for a server without a node
  int64_t epoch = 0;
};

/// Returns the statements that make a session with its roles, held by `holding`. With
/// `has_shared_scan` they fail with not_found if the catalogue of scans does not have its scan.
std::vector<PgStatement> make_session_rows(const SessionRecord& record, const SessionRoles& roles,
                                           const Holding& holding, bool has_shared_scan = false);

/// Returns the statement that gives a role. It changes no row if the session is held otherwise, and
/// waits for whoever takes the session at this moment.
PgStatement put_role_row(const std::string& session_id, const std::string& user, SessionRole role,
                         const Holding& holding);

/// The condition that a row of sessions is held, with the epoch and the life as values of these
/// numbers.
std::string is_held(int epoch, int life);

/// Returns the statement that enters one edit, and counts it in the session's row. It changes no
/// row if the session is held otherwise, or does not end before `number`.
PgStatement add_edit_row(const std::string& session_id, uint64_t number, const AuthoredEdit& edit,
                         const Holding& holding);

/// Returns the session of a row of kSelectSessions.
inline constexpr char kSelectSessions[] =
    "SELECT id, name, scan_id, depth, curvature_radius, created_unix_seconds, pins_rims, checksum,"
    " maker, maker_checksum FROM sessions";
SessionRecord session_of_row(const PgReply& reply, size_t row);

/// Returns the checksum of a session's row.
std::string checksum_of(const SessionRecord& record);

/// Returns the session's edits by number, with a Damaged edit in place of a damaged or missing one.
/// Fails: data_loss if the session's own row is damaged; unavailable.
Result<std::vector<AuthoredEdit>> read_edit_rows(PgConnection& database,
                                                 const std::string& session_id);

/// Gives the least role to users whose role is damaged, and to everybody if that role is missing.
Result<SessionRoles> read_role_rows(PgConnection& database, const std::string& session_id);

}  // namespace burnish
