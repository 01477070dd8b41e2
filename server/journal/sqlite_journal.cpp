#include "server/journal/sqlite_journal.h"

#include <map>
#include <optional>

#include <spdlog/spdlog.h>

#include "server/journal/forked_edits.h"
#include "server/journal/paint_rows.h"
#include "server/journal/sqlite_rows.h"
#include "server/journal/sqlite_schema.h"

namespace burnish {

/// Turns edits that the write-ahead log has lost into missing edits: clients know their numbers.
/// Returns the last number of each session.
static Result<std::map<std::string, uint64_t>> compare_ends(Database& database,
                                                            const JournalEnds& seen) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::begin(database));
  ASSIGN_OR_RETURN(const auto sessions, read_sessions(database));
  std::map<std::string, uint64_t> ends;
  for (const SessionRecord& session : sessions) {
    ASSIGN_OR_RETURN(ends[session.id], last_number(database, session.id));
  }
  for (const auto& [id, number] : seen.read()) {
    const auto end = ends.find(id);
    if (end == ends.end()) {
      spdlog::error("session {} with {} edits is missing from the journal", id, number);
    } else if (end->second < number) {
      spdlog::error("session {}: the journal ends at edit {}, but it had reached edit {} before",
                    id, end->second, number);
      RETURN_IF_ERROR(set_last_number(database, id, number));
      end->second = number;
    }
  }
  RETURN_IF_ERROR(transaction.commit().status());
  return ends;
}

static Status with_way_out(const Status& status) {
  if (status.code() != StatusCode::kDataLoss) return status;
  return data_loss(status.message() +
                   "; put a backup in its place, or see \"Damage\" in the server's README");
}

/// Opens the file, with the newest schema.
static Result<Database> open_database(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(Database database, Database::open(path));
  RETURN_IF_ERROR(make_journal_schema(database).with_context(path.string()));
  return database;
}

Result<std::unique_ptr<Journal>> SqliteJournal::open(const std::filesystem::path& path) {
  auto opened = open_database(path);
  if (!opened.is_ok()) return with_way_out(opened.status());
  Database database = std::move(opened).value();
  ASSIGN_OR_RETURN(const auto users, read_users_of_damaged_roles(database));
  for (const std::string& user : users)
    spdlog::error("a role of user '{}' in the journal is damaged", user);
  auto ends_path = path;
  auto ends = std::make_unique<JournalEnds>(ends_path.replace_extension(".ends"));
  const auto now = compare_ends(database, *ends);
  RETURN_IF_ERROR(with_way_out(now.status().with_context(path.string())));
  ends->begin(*now);
  return std::unique_ptr<Journal>(new SqliteJournal(std::move(database), std::move(ends)));
}

namespace {

Result<int64_t> free_pages(Database& database) {
  ASSIGN_OR_RETURN(Statement query, database.prepare("PRAGMA freelist_count"));
  RETURN_IF_ERROR(query.run());
  return query.integer(0);
}

}  // namespace

template <typename T>
Result<T> SqliteJournal::read(const std::function<Result<T>(Database&)>& work) {
  std::optional<Result<T>> result;
  RETURN_IF_ERROR(commit_.read([&](Database& database) {
    result = work(database);
    return Status::ok();
  }));
  return std::move(*result);
}

Result<std::vector<SessionRecord>> SqliteJournal::sessions() {
  ASSIGN_OR_RETURN(auto records, read<std::vector<SessionRecord>>(read_sessions));
  for (const SessionRecord& record : records)
    if (record.is_damaged)
      spdlog::error("session {} ({}): its row in the journal is damaged", record.id, record.name);
  return records;
}

Status SqliteJournal::create_session(const SessionRecord& record, const SessionRoles& roles) {
  return commit_.write([&](Database& database) { return insert_session(database, record, roles); });
}

Status SqliteJournal::rename_session(const std::string& id, const std::string& name) {
  return commit_.write(
      [&](Database& database) { return burnish::rename_session(database, id, name); });
}

Status SqliteJournal::remove_session(const std::string& id) {
  RETURN_IF_ERROR(commit_.write(
      [&](Database& database) { return run(database, "DELETE FROM sessions WHERE id = ?", id); }));
  ends_->forget(id);
  shrink();
  return Status::ok();
}

void SqliteJournal::shrink() {
  const auto left = std::make_shared<int64_t>(0);
  commit_.post_background(
      [left](Database& database) -> Status {
        ASSIGN_OR_RETURN(const int64_t before, free_pages(database));
        RETURN_IF_ERROR(database.execute("PRAGMA incremental_vacuum(256)"));
        ASSIGN_OR_RETURN(const int64_t after, free_pages(database));
        *left = after < before ? after : 0;  // an old journal cannot shrink
        return Status::ok();
      },
      [this, left](const WriteOutcome& outcome) {
        if (outcome.is_on_disk() && *left > 0 && !ending_) shrink();
      });
}

static Status copy_paint(Database& database, const SessionRecord& from, const SessionRecord& to) {
  return run(database,
             "INSERT INTO paint (session_id, series, strokes, bytes)"
             " SELECT ?, series, strokes, bytes FROM paint WHERE session_id = ?"
             " ORDER BY sequence",
             to.id, from.id);
}

Result<uint64_t> SqliteJournal::fork_session(const SessionRecord& source, uint64_t edits,
                                             const SessionRecord& record,
                                             const SessionRoles& roles) {
  uint64_t emptied = 0;
  const Status status = commit_.write([&](Database& database) -> Status {
    ASSIGN_OR_RETURN(auto all, read_edits(database, source.id));
    ASSIGN_OR_RETURN(const ForkedEdits forked,
                     edits_of_fork(std::move(all), edits, source, record));
    emptied = forked.emptied;
    RETURN_IF_ERROR(insert_session(database, record, roles));
    RETURN_IF_ERROR(insert_edits(database, record.id, 1, forked.edits));
    return has_same_cells(source, record) ? copy_paint(database, source, record) : Status::ok();
  });
  RETURN_IF_ERROR(status);
  ends_->note(record.id, edits);
  return emptied;
}

void SqliteJournal::append(const std::string& session_id, uint64_t first,
                           std::vector<AuthoredEdit> edits, Done done) {
  const uint64_t last = first + edits.size() - 1;
  commit_.post([session_id, first, edits = std::move(edits)](
                   Database& database) { return insert_edits(database, session_id, first, edits); },
               [this, session_id, last, done = std::move(done)](const WriteOutcome& outcome) {
                 if (outcome.is_on_disk()) ends_->note(session_id, last);
                 done(outcome);
               });
}

Result<std::vector<AuthoredEdit>> SqliteJournal::edits(const std::string& session_id) {
  return read<std::vector<AuthoredEdit>>(
      [&](Database& database) { return read_edits(database, session_id); });
}

Result<uint64_t> SqliteJournal::edit_count(const std::string& session_id) {
  return read<uint64_t>([&](Database& database) { return last_number(database, session_id); });
}

Result<uint64_t> SqliteJournal::history_bytes(const std::string& session_id) {
  return read<uint64_t>([&](Database& database) -> Result<uint64_t> {
    ASSIGN_OR_RETURN(Statement sum,
                     database.prepare("SELECT IFNULL(SUM(LENGTH(bytes) + LENGTH(author) +"
                                      " LENGTH(id) + ?2), 0) FROM edits WHERE session_id = ?1"));
    RETURN_IF_ERROR(sum.bind(session_id, static_cast<int64_t>(kHistoryBytesOfARow)).run());
    return static_cast<uint64_t>(sum.integer(0));
  });
}

Result<SessionRoles> SqliteJournal::roles(const std::string& session_id) {
  return read<SessionRoles>([&](Database& database) -> Result<SessionRoles> {
    ASSIGN_OR_RETURN(const auto damaged, read_users_of_damaged_roles(database));
    return read_roles(database, session_id, damaged);
  });
}

Status SqliteJournal::set_role(const std::string& session_id, const std::string& user,
                               SessionRole role) {
  return commit_.write(
      [&](Database& database) { return insert_role(database, session_id, user, role); });
}

Status SqliteJournal::enter_all(const NextSession& next) {
  std::map<std::string, uint64_t> ends;
  const auto enter = [&](Database& database) -> Status {
    for (;;) {
      ASSIGN_OR_RETURN(const auto session, next());
      if (!session) return Status::ok();
      RETURN_IF_ERROR(insert_session(database, session->record, session->roles));
      RETURN_IF_ERROR(insert_edits(database, session->record.id, 1, session->edits));
      ends[session->record.id] = session->edits.size();
    }
  };
  RETURN_IF_ERROR(commit_.write(enter));
  for (const auto& [id, number] : ends) ends_->note(id, number);
  return Status::ok();
}

void SqliteJournal::keep_paint(const std::string& session_id, const PaintCheckpoint& paint) {
  keep_paint_row(commit_, session_id, paint);
}

Result<std::vector<PaintCheckpoint>> SqliteJournal::paint(const std::string& session_id,
                                                          size_t cell_count) {
  return read_paint_rows(commit_, session_id, cell_count);
}

}  // namespace burnish
