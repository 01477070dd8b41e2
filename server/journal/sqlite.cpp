#include "server/journal/sqlite.h"

#include <chrono>

#include <sqlite3.h>

#include "server/journal/row_checksum.h"
#include "server/metrics/metrics.h"

namespace burnish {

static std::string_view bytes_of(sqlite3_value* value) {
  const auto* bytes = static_cast<const char*>(sqlite3_value_blob(value));
  return {bytes, static_cast<size_t>(sqlite3_value_bytes(value))};
}

static void add_value(RowChecksum& sum, sqlite3_value* value) {
  switch (sqlite3_value_type(value)) {
    case SQLITE_INTEGER:
      return sum.add(int64_t{sqlite3_value_int64(value)});
    case SQLITE_FLOAT:
      return sum.add(sqlite3_value_double(value));
    case SQLITE_NULL:
      return sum.add_null();
    case SQLITE_TEXT:
      return sum.add_text(bytes_of(value));
    default:
      sum.add(bytes_of(value));
  }
}

static void row_checksum(sqlite3_context* context, int count, sqlite3_value** values) {
  auto& sum = *static_cast<RowChecksum*>(sqlite3_user_data(context));
  for (int i = 0; i < count; ++i) add_value(sum, values[i]);
  const std::string bytes = sum.take();
  sqlite3_result_blob(context, bytes.data(), static_cast<int>(bytes.size()), SQLITE_TRANSIENT);
}

// Adds the SQL function row_checksum(VALUE, ...) to a connection. It returns 16 bytes, the
// XXH3-128 of the values with their types and lengths. Journals keep the result, so the function
// must never change. It finds damage, not forgery. Returns false without memory.
static bool add_row_checksum(sqlite3* database) {
  const auto free_sum = [](void* kept) { delete static_cast<RowChecksum*>(kept); };
  // SQLite frees the sum, even if this fails.
  return sqlite3_create_function_v2(database, "row_checksum", -1,
                                    SQLITE_UTF8 | SQLITE_DETERMINISTIC, new RowChecksum,
                                    row_checksum, nullptr, nullptr, free_sum) == SQLITE_OK;
}

static StatusCode code_of_sqlite(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
    case SQLITE_NOMEM:
    case SQLITE_TOOBIG:
      return StatusCode::kResourceExhausted;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return StatusCode::kDataLoss;
    case SQLITE_CONSTRAINT:
      return StatusCode::kAlreadyExists;
    case SQLITE_PERM:
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
      return StatusCode::kPermissionDenied;
    default:
      return StatusCode::kInternal;
  }
}

static Status sqlite_status(sqlite3* database, int code) {
  return {code_of_sqlite(code), std::string("journal: ") + sqlite3_errmsg(database)};
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Statement::bind_one(std::string_view bytes) {
  sqlite3_bind_blob64(statement_.get(), ++bound_, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
}

void Statement::bind_one(int64_t value) {
  sqlite3_bind_int64(statement_.get(), ++bound_, value);
}

void Statement::bind_one(double value) {
  sqlite3_bind_double(statement_.get(), ++bound_, value);
}

void Statement::reset() {
  sqlite3_reset(statement_.get());
  bound_ = 0;
}

Result<bool> Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return sqlite_status(sqlite3_db_handle(statement_.get()), code);
}

std::string Statement::text(int column) const {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return size == 0 ? std::string()
                   : std::string(static_cast<const char*>(bytes), static_cast<size_t>(size));
}

int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);
}

Result<Database> Database::open_with(const std::filesystem::path& path, int flags) {
  Database result;
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READWRITE | flags, nullptr);
  result.database_.reset(opened);
  if (code != SQLITE_OK) return sqlite_status(opened, code).with_context(path.string());
  return result;
}

Result<Database> Database::open_as_it_is(const std::filesystem::path& path) {
  return open_with(path, 0);
}

Result<Database> Database::open(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(Database result, open_with(path, SQLITE_OPEN_CREATE));
  // Takes effect only in a new, empty file.
  RETURN_IF_ERROR(result.execute("PRAGMA auto_vacuum=INCREMENTAL").with_context(path.string()));
  RETURN_IF_ERROR(result.execute("PRAGMA journal_mode=WAL").with_context(path.string()));
  RETURN_IF_ERROR(result.execute("PRAGMA synchronous=FULL"));
  RETURN_IF_ERROR(result.execute("PRAGMA foreign_keys=ON"));
  RETURN_IF_ERROR(result.execute("PRAGMA cell_size_check=ON"));
  // Debian's default overwrites deleted data: deleting would need as much disk as it frees.
  RETURN_IF_ERROR(result.execute("PRAGMA secure_delete=OFF"));
  sqlite3* const opened = result.database_.get();
  if (!add_row_checksum(opened)) return sqlite_status(opened, sqlite3_errcode(opened));
  return result;
}

Status Database::execute(const char* sql) {
  const int code = sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
  return code == SQLITE_OK ? Status::ok() : sqlite_status(database_.get(), code);
}

bool Database::failed_beyond_write() const {
  const int code = sqlite3_extended_errcode(database_.get());
  return (code & 0xff) == SQLITE_IOERR && code != SQLITE_IOERR_WRITE;
}

Result<Statement> Database::prepare(const char* sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr);
  if (code != SQLITE_OK) return sqlite_status(database_.get(), code);
  return Statement(statement);
}

Result<Transaction> Transaction::begin(Database& database) {
  RETURN_IF_ERROR(database.execute("BEGIN IMMEDIATE"));
  return Transaction(database);
}

Transaction::~Transaction() {
  if (database_) (void)database_->execute("ROLLBACK");
}

WriteOutcome Transaction::commit() {
  const auto start = std::chrono::steady_clock::now();
  const Status status = database_->execute("COMMIT");
  if (!status.is_ok())
    return database_->failed_beyond_write() ? WriteOutcome::unknown(status)
                                            : WriteOutcome::refused(status);
  metrics().observe(
      Measure::kJournalCommitSeconds,
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  database_ = nullptr;
  return {};
}

}  // namespace burnish
