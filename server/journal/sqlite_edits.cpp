// The journal's rows of edits, and their recovery after damage.

#include <algorithm>

#include "common/base/text.h"
#include "common/wire/edit_bytes.h"
#include "server/journal/damaged_edits.h"
#include "server/journal/sqlite_rows.h"

namespace burnish {

Result<uint64_t> last_number(Database& database, const std::string& session_id) {
  ASSIGN_OR_RETURN(Statement query,
                   database.prepare("SELECT number FROM ends WHERE session_id = ?1"
                                    " AND checksum = row_checksum(session_id, number)"));
  ASSIGN_OR_RETURN(const bool is_good, query.bind(session_id).step());
  if (is_good) return static_cast<uint64_t>(query.integer(0));
  // Works because numbers have no gaps.
  ASSIGN_OR_RETURN(Statement count,
                   database.prepare("SELECT COUNT(*) FROM edits WHERE session_id = ?"));
  RETURN_IF_ERROR(count.bind(session_id).run());
  return static_cast<uint64_t>(count.integer(0));
}

namespace {

Status insert_all(Database& database, const std::string& session_id, uint64_t first,
                  const std::vector<AuthoredEdit>& edits) {
  ASSIGN_OR_RETURN(Statement insert, database.prepare("INSERT INTO edits VALUES"
                                                      " (?1, ?2, ?3, ?4, ?5, ?6,"
                                                      " row_checksum(?1, ?2, ?3, ?4, ?5, ?6))"));
  for (size_t i = 0; i < edits.size(); ++i) {
    const AuthoredEdit& edit = edits[i];
    const uint64_t number = first + i;
    if (kind_of(edit.edit) == EditKind::kDamaged) {
      RETURN_IF_ERROR(run(database, "INSERT INTO edits VALUES (?, ?, ?, ?, ?, x'', x'')",
                          session_id, static_cast<int64_t>(number), edit.author,
                          id_of_damaged(number), edit.unix_ms));
      continue;
    }
    insert.reset();
    RETURN_IF_ERROR(insert
                        .bind(session_id, static_cast<int64_t>(number), edit.author, edit.edit.id,
                              edit.unix_ms, edit_to_bytes(edit.edit))
                        .run());
  }
  return Status::ok();
}

/// The edits of one session, gathered by number from several ways of reading.
class Gathered {
 public:
  explicit Gathered(uint64_t count) : edits_(count, missing_edit()), found_(count) {}

  Status take(const Statement& row) {
    const auto number = static_cast<uint64_t>(row.integer(0));
    if (number < 1 || number > edits_.size()) return Status::ok();
    const size_t i = number - 1;
    if (found_[i]) return Status::ok();
    found_[i] = true;
    ++found_count_;
    AuthoredEdit& edit = edits_[i];
    edit.author = to_valid_utf8(row.text(1));
    edit.unix_ms = row.integer(2);
    read_kept_edit(row.text(3), row.integer(4) != 0, edit.edit);
    return Status::ok();
  }

  bool is_complete() const { return found_count_ == edits_.size(); }
  bool has(uint64_t number) const { return found_[number - 1]; }
  std::vector<AuthoredEdit> edits() && { return std::move(edits_); }

 private:
  std::vector<AuthoredEdit> edits_;
  std::vector<bool> found_;
  size_t found_count_ = 0;
};

constexpr char kReadAll[] =
    "SELECT number, author, unix_ms, bytes,"
    " checksum = row_checksum(session_id, number, author, id, unix_ms, bytes)"
    " FROM edits WHERE session_id = ? ORDER BY number";
constexpr char kReadOne[] =
    "SELECT number, author, unix_ms, bytes,"
    " checksum = row_checksum(session_id, number, author, id, unix_ms, bytes)"
    " FROM edits WHERE session_id = ? AND number = ?";

Status check_session(Database& database, const std::string& session_id) {
  ASSIGN_OR_RETURN(
      Statement query,
      database.prepare("SELECT checksum = row_checksum(id, name, scan_id, depth, curvature_radius,"
                       " created_unix_seconds, pins_rims) FROM sessions WHERE id = ?"));
  ASSIGN_OR_RETURN(const bool is_there, query.bind(session_id).step());
  if (!is_there || query.integer(0) != 0) return Status::ok();
  return data_loss(kDamagedSessionRow);
}

}  // namespace

Status insert_edits(Database& database, const std::string& session_id, uint64_t first,
                    const std::vector<AuthoredEdit>& edits) {
  ASSIGN_OR_RETURN(const uint64_t last, last_number(database, session_id));
  if (last + 1 != first)
    return data_loss("the session's edits end at " + std::to_string(last) + "; the next one is " +
                     std::to_string(first) + ", so some were not written");
  if (edits.empty()) return Status::ok();
  RETURN_IF_ERROR(insert_all(database, session_id, first, edits));
  return set_last_number(database, session_id, last + edits.size());
}

Status set_last_number(Database& database, const std::string& session_id, uint64_t number) {
  return run(database, "INSERT OR REPLACE INTO ends VALUES (?1, ?2, row_checksum(?1, ?2))",
             session_id, static_cast<int64_t>(number));
}

Result<std::vector<AuthoredEdit>> read_edits(Database& database, const std::string& session_id) {
  RETURN_IF_ERROR(check_session(database, session_id));
  ASSIGN_OR_RETURN(const uint64_t last, last_number(database, session_id));
  Gathered gathered(last);
  const auto take = [&](const Statement& row) { return gathered.take(row); };
  Status status = read_rows(database, kReadAll, take, session_id);
  if (!gathered.is_complete()) {
    // Rows may still exist though the index does not lead to them. Edits that this cannot restore
    // are marked as damaged.
    (void)database.execute("REINDEX edits");
    status = read_rows(database, kReadAll, take, session_id);
  }
  // A damaged page ends a reading of many rows. Rows of other pages can still be read one by one.
  for (uint64_t number = 1; !status.is_ok() && number <= last; ++number)
    if (!gathered.has(number))
      (void)read_rows(database, kReadOne, take, session_id, static_cast<int64_t>(number));
  return std::move(gathered).edits();
}

}  // namespace burnish
