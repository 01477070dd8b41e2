#include "server/journal/sqlite_rows.h"

#include <algorithm>
#include <map>

#include <spdlog/spdlog.h>

#include "common/base/text.h"
#include "server/journal/session_maker.h"

namespace burnish {

Status insert_session(Database& database, const SessionRecord& record, const SessionRoles& roles) {
  RETURN_IF_ERROR(run(database,
                      "INSERT INTO sessions (id, name, scan_id, depth, curvature_radius,"
                      " created_unix_seconds, pins_rims, checksum, maker, maker_checksum) VALUES"
                      " (?1, ?2, ?3, ?4, ?5, ?6, ?7, row_checksum(?1, ?2, ?3, ?4, ?5, ?6, ?7),"
                      " ?8, ?9)",
                      record.id, record.name, record.scan_id, int64_t{record.key.depth},
                      record.key.curvature_radius, record.created_unix_seconds,
                      int64_t{record.controls.pin_rims}, record.maker.value_or(""),
                      checksum_of_maker(record)));
  for (const auto& [user, role] : roles.by_user())
    RETURN_IF_ERROR(insert_role(database, record.id, user, role));
  return Status::ok();
}

/// Only a damaged record can have the name of another session.
static void tell_apart(std::vector<SessionRecord>& records) {
  for (SessionRecord& record : records) {
    if (!record.is_damaged) continue;
    const auto namesakes =
        std::count_if(records.begin(), records.end(),
                      [&](const SessionRecord& other) { return other.name == record.name; });
    if (namesakes > 1) record.name += "-" + record.id;
  }
}

Result<std::vector<SessionRecord>> read_sessions(Database& database) {
  std::vector<SessionRecord> records;
  const auto take = [&](const Statement& row) {
    records.push_back({to_valid_utf8(row.text(0)),
                       to_valid_utf8(row.text(1)),
                       to_valid_utf8(row.text(2)),
                       {static_cast<int>(row.integer(3)), row.real(4)},
                       row.integer(5),
                       {.pin_rims = row.integer(6) != 0},
                       row.integer(7) == 0,
                       maker_of_row(row.text(0), row.text(8), row.text(9))});
    return Status::ok();
  };
  // Reads without the index of names, which may be damaged too.
  RETURN_IF_ERROR(read_rows(database,
                            "SELECT id, name, scan_id, depth, curvature_radius,"
                            " created_unix_seconds, pins_rims, checksum = row_checksum(id, name,"
                            " scan_id, depth, curvature_radius, created_unix_seconds, pins_rims),"
                            " maker, maker_checksum FROM sessions ORDER BY +name",
                            take));
  tell_apart(records);
  return records;
}

// A new checksum must not turn a damaged row into a good one.
Status rename_session(Database& database, const std::string& id, const std::string& name) {
  ASSIGN_OR_RETURN(const auto sessions, read_sessions(database));
  const auto same_id = [&](const SessionRecord& each) { return each.id == id; };
  const auto session = std::find_if(sessions.begin(), sessions.end(), same_id);
  if (session == sessions.end()) return not_found("no session has the id '" + id + "'");
  if (session->is_damaged)
    return data_loss("session " + session->name + ": its row in the journal is damaged");
  for (const SessionRecord& other : sessions)
    if (other.name == name && other.id != id)
      return already_exists("session " + name + " already exists");
  return run(database,
             "UPDATE sessions SET name = ?2, checksum = row_checksum(id, ?2, scan_id, depth,"
             " curvature_radius, created_unix_seconds, pins_rims) WHERE id = ?1",
             id, name);
}

Status insert_role(Database& database, const std::string& session_id, const std::string& user,
                   SessionRole role) {
  return run(database, "INSERT OR REPLACE INTO roles VALUES (?1, ?2, ?3, row_checksum(?1, ?2, ?3))",
             session_id, user, static_cast<int64_t>(role));
}

Result<std::set<std::string>> read_users_of_damaged_roles(Database& database) {
  std::set<std::string> users;
  const auto take = [&](const Statement& row) {
    users.insert(to_valid_utf8(row.text(0)));
    return Status::ok();
  };
  RETURN_IF_ERROR(read_rows(database,
                            "SELECT user FROM roles"
                            " WHERE checksum <> row_checksum(session_id, user, role)",
                            take));
  return users;
}

Result<SessionRoles> read_roles(Database& database, const std::string& session_id,
                                const std::set<std::string>& users_of_damaged) {
  std::map<std::string, SessionRole> roles;
  const auto take = [&](const Statement& row) {
    const auto role = static_cast<SessionRole>(row.integer(1));
    const std::string user = row.text(0);
    // A role that was later given to the name as it is shown counts before the old one.
    if (is_valid_utf8(user)) {
      roles[user] = role;
    } else {
      roles.try_emplace(to_valid_utf8(user), role);
    }
    return Status::ok();
  };
  RETURN_IF_ERROR(read_rows(database,
                            "SELECT user, role FROM roles WHERE session_id = ?"
                            " AND checksum = row_checksum(session_id, user, role)",
                            take, session_id));
  for (const std::string& user : users_of_damaged) roles.try_emplace(user, SessionRole::kViewer);
  if (roles.try_emplace("", SessionRole::kViewer).second)
    spdlog::error("session {}: roles are missing from the journal", session_id);
  return SessionRoles(std::move(roles));
}

}  // namespace burnish
