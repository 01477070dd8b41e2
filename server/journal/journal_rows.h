#pragma once

#include <set>
#include <string>
#include <vector>

#include "common/edit/edit.h"
#include "common/service/session_roles.h"
#include "server/journal/journal.h"
#include "server/journal/sqlite.h"

namespace burnish {

// The journal's rows, each with its checksum. Text comes back as UTF-8 whatever it was.

Status insert_session(Database& database, const SessionRecord& record, const SessionRoles& roles);

/// By name. Damaged ones are marked, and named so that no two names are one.
Result<std::vector<SessionRecord>> read_sessions(Database& database);

Status insert_role(Database& database, const std::string& session_id, const std::string& user,
                   SessionRole role);

/// Of all sessions: a damaged row does not say for sure whose it is.
Result<std::set<std::string>> read_users_of_damaged_roles(Database& database);

/// Who may have had a role that is damaged, and everybody where that role is gone, has the least.
Result<SessionRoles> read_roles(Database& database, const std::string& session_id,
                                const std::set<std::string>& users_of_damaged);

/// The number of the session's last edit, whether that can be read or not; 0: it has none.
Result<uint64_t> last_number(Database& database, const std::string& session_id);

/// Fails: already_exists (an id that the author has used), data_loss (`first` does not follow the
/// last edit). A damaged edit keeps its number, and stays damaged.
Status insert_edits(Database& database, const std::string& session_id, uint64_t first,
                    const std::vector<AuthoredEdit>& edits);

/// Says that the session's last edit has this number, whatever is there of it.
Status set_last_number(Database& database, const std::string& session_id, uint64_t number);

/// All edits by number; what is damaged or gone is a Damaged one. Puts the index right where that
/// was at fault. Fails: data_loss when the session's own row is damaged; as SQLite says.
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
