#pragma once

#include <set>
#include <string>
#include <vector>

#include "common/edit/edit.h"
#include "common/service/session_roles.h"
#include "server/journal/journal.h"
#include "server/journal/sqlite.h"

namespace burnish {

// The journal's rows, each with its checksum. Text comes back as valid UTF-8, whatever it was.

Status insert_session(Database& database, const SessionRecord& record, const SessionRoles& roles);

/// Fails: already_exists (another session has the name), data_loss (the session's row is damaged),
/// not_found.
Status rename_session(Database& database, const std::string& id, const std::string& name);

/// Returns the sessions by name. Damaged ones are marked; each gets a name of its own.
Result<std::vector<SessionRecord>> read_sessions(Database& database);

Status insert_role(Database& database, const std::string& session_id, const std::string& user,
                   SessionRole role);

/// Returns users of all sessions: a damaged row does not say for sure whose role it is.
Result<std::set<std::string>> read_users_of_damaged_roles(Database& database);

/// Gives the least role to users who may have had a damaged role, and to everybody if that role is
/// missing.
Result<SessionRoles> read_roles(Database& database, const std::string& session_id,
                                const std::set<std::string>& users_of_damaged);

/// Returns the number of the session's last edit, even if it cannot be read; 0 without edits.
Result<uint64_t> last_number(Database& database, const std::string& session_id);

/// Fails: already_exists (the author has used an id before), data_loss (`first` does not follow the
/// last edit). A damaged edit keeps its number and stays damaged.
Status insert_edits(Database& database, const std::string& session_id, uint64_t first,
                    const std::vector<AuthoredEdit>& edits);

/// Notes that the session's last edit has this number, even if the edit is missing.
Status set_last_number(Database& database, const std::string& session_id, uint64_t number);

/// Returns all edits by number, with a Damaged edit in place of a damaged or missing one. Repairs a
/// wrong index. Fails: data_loss if the session's own row is damaged; as SQLite says.
Result<std::vector<AuthoredEdit>> read_edits(Database& database, const std::string& session_id);

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

}  // namespace burnish
