#include "server/journal/postgres_rows.h"

#include <map>

#include <spdlog/spdlog.h>

#include "common/base/text.h"
#include "common/wire/edit_bytes.h"
#include "server/journal/damaged_edits.h"
#include "server/journal/row_checksum.h"
#include "server/journal/session_maker.h"

namespace burnish {

std::string checksum_of(const SessionRecord& record) {
  return row_checksum_of(record.id, record.name, record.scan_id, int64_t{record.key.depth},
                         record.key.curvature_radius, record.created_unix_seconds,
                         int64_t{record.controls.pin_rims});
}

std::vector<PgStatement> make_session_rows(const SessionRecord& record, const SessionRoles& roles,
                                           const Holding& holding, bool has_shared_scan) {
  std::vector<PgStatement> statements = {
      {"INSERT INTO sessions (id, name, scan_id, depth, curvature_radius, created_unix_seconds,"
       " pins_rims, checksum, owner, epoch, shared_scan, maker, maker_checksum) VALUES ($1, $2, $3,"
       " $4, $5, $6, $7, $8, CAST(NULLIF($9, '') AS uuid), $10, CASE WHEN $11 = 1 THEN $3 END,"
       " $12, $13)",
       {record.id, record.name, record.scan_id, int64_t{record.key.depth},
        record.key.curvature_radius, record.created_unix_seconds, int64_t{record.controls.pin_rims},
        checksum_of(record), PgText{holding.life}, holding.epoch, int64_t{has_shared_scan},
        record.maker.value_or(""), checksum_of_maker(record)}}};
  for (const auto& [user, role] : roles.by_user())
    statements.push_back(put_role_row(record.id, user, role, holding));
  return statements;
}

std::string is_held(int epoch, int life) {
  return "epoch = $" + std::to_string(epoch) + " AND owner IS NOT DISTINCT FROM CAST(NULLIF($" +
         std::to_string(life) + ", '') AS uuid)";
}

PgStatement put_role_row(const std::string& session_id, const std::string& user, SessionRole role,
                         const Holding& holding) {
  const auto number = static_cast<int64_t>(role);
  return {"WITH held AS (SELECT id FROM sessions WHERE id = $1 AND " + is_held(5, 6) +
              " FOR SHARE)"
              " INSERT INTO roles SELECT $1, $2, $3, $4 FROM held"
              " ON CONFLICT (session_id, \"user\")"
              " DO UPDATE SET role = excluded.role, checksum = excluded.checksum",
          {session_id, user, number, row_checksum_of(session_id, user, number), holding.epoch,
           PgText{holding.life}}};
}

PgStatement add_edit_row(const std::string& session_id, uint64_t number, const AuthoredEdit& edit,
                         const Holding& holding) {
  const auto n = static_cast<int64_t>(number);
  const bool is_damaged = kind_of(edit.edit) == EditKind::kDamaged;
  const std::string id = is_damaged ? id_of_damaged(number) : edit.edit.id;
  const std::string bytes = is_damaged ? std::string() : edit_to_bytes(edit.edit);
  const std::string sum =
      is_damaged ? std::string()
                 : row_checksum_of(session_id, n, edit.author, id, edit.unix_ms, bytes);
  static const std::string kAdd =
      "WITH held AS (UPDATE sessions SET edits = $2 WHERE id = $1 AND edits = $2 - 1 AND " +
      is_held(4, 3) +
      " RETURNING id)"
      " INSERT INTO edits SELECT $1, $2, $4, $5, $6, $7, $8, $9 FROM held";
  return {kAdd,
          {session_id, n, PgText{holding.life}, holding.epoch, edit.author, id, edit.unix_ms, bytes,
           sum}};
}

SessionRecord session_of_row(const PgReply& reply, size_t row) {
  SessionRecord record{
      reply.bytes(row, 0),   reply.bytes(row, 1),
      reply.bytes(row, 2),   {static_cast<int>(reply.integer(row, 3)), reply.real(row, 4)},
      reply.integer(row, 5), {.pin_rims = reply.integer(row, 6) != 0}};
  record.is_damaged = reply.bytes(row, 7) != checksum_of(record);
  record.maker = maker_of_row(record.id, reply.bytes(row, 8), reply.bytes(row, 9));
  for (std::string* text : {&record.id, &record.name, &record.scan_id})
    *text = to_valid_utf8(*text);
  return record;
}

static Status check_session_row(PgConnection& database, const std::string& session_id,
                                uint64_t& count) {
  ASSIGN_OR_RETURN(const PgReply reply,
                   database.run({"SELECT id, name, scan_id, depth, curvature_radius,"
                                 " created_unix_seconds, pins_rims, checksum, maker,"
                                 " maker_checksum, edits FROM sessions WHERE id = $1",
                                 {session_id}}));
  count = reply.rows() == 0 ? 0 : static_cast<uint64_t>(reply.integer(0, 10));
  if (reply.rows() == 0) return Status::ok();
  static constexpr uint64_t kEditsMax = 100'000'000;
  if (session_of_row(reply, 0).is_damaged || count > kEditsMax)
    return data_loss(kDamagedSessionRow);
  return Status::ok();
}

static AuthoredEdit edit_of_row(const PgReply& reply, size_t row, const std::string& session_id) {
  const std::string author = reply.bytes(row, 1), id = reply.bytes(row, 2);
  const int64_t unix_ms = reply.integer(row, 3);
  const std::string bytes = reply.bytes(row, 4);
  AuthoredEdit edit{to_valid_utf8(author), unix_ms, {}};
  const std::string sum =
      row_checksum_of(session_id, reply.integer(row, 0), author, id, unix_ms, bytes);
  read_kept_edit(bytes, sum == reply.bytes(row, 5), edit.edit);
  return edit;
}

Result<std::vector<AuthoredEdit>> read_edit_rows(PgConnection& database,
                                                 const std::string& session_id) {
  uint64_t count = 0;
  RETURN_IF_ERROR(check_session_row(database, session_id, count));
  ASSIGN_OR_RETURN(const PgReply reply,
                   database.run({"SELECT number, author, id, unix_ms, bytes, checksum FROM edits"
                                 " WHERE session_id = $1 AND number BETWEEN 1 AND $2",
                                 {session_id, static_cast<int64_t>(count)}}));
  std::vector<AuthoredEdit> edits(count, missing_edit());
  for (size_t row = 0; row < reply.rows(); ++row)
    edits[static_cast<size_t>(reply.integer(row, 0)) - 1] = edit_of_row(reply, row, session_id);
  return edits;
}

Result<SessionRoles> read_role_rows(PgConnection& database, const std::string& session_id) {
  ASSIGN_OR_RETURN(const PgReply reply,
                   database.run({"SELECT \"user\", role, checksum FROM roles WHERE session_id = $1",
                                 {session_id}}));
  std::map<std::string, SessionRole> roles;
  for (size_t row = 0; row < reply.rows(); ++row) {
    const std::string user = reply.bytes(row, 0);
    const int64_t role = reply.integer(row, 1);
    const bool is_good = reply.bytes(row, 2) == row_checksum_of(session_id, user, role);
    if (!is_good) spdlog::error("a role of user '{}' in the journal is damaged", user);
    const SessionRole given = is_good ? static_cast<SessionRole>(role) : SessionRole::kViewer;
    // A role that was later given to the name as it is shown counts before the old one.
    if (is_valid_utf8(user)) {
      roles[user] = given;
    } else {
      roles.try_emplace(to_valid_utf8(user), given);
    }
  }
  if (roles.try_emplace("", SessionRole::kViewer).second)
    spdlog::error("session {}: roles are missing from the journal", session_id);
  return SessionRoles(std::move(roles));
}

}  // namespace burnish
