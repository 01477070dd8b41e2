#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/status.h"
#include "server/journal/write_outcome.h"

struct sqlite3;
struct sqlite3_stmt;

namespace burnish {

/// One prepared statement. bind(...) sets its values from the left; step() reads row by row.
class Statement {
 public:
  template <typename... Values>
  Statement& bind(const Values&... values) {
    (bind_one(values), ...);
    return *this;
  }

  /// Goes back to the beginning, for new values.
  void reset();

  /// Returns true if a row can be read, false at the end. Fails: as SQLite says.
  Result<bool> step();

  /// For statements without rows.
  Status run() { return step().status(); }

  std::string text(int column) const;  ///< for text and blobs
  int64_t integer(int column) const;
  double real(int column) const;

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}

  void bind_one(std::string_view bytes);  // as a blob, so that text and bytes come back unchanged
  void bind_one(int64_t value);
  void bind_one(double value);

  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int bound_ = 0;
};

/// A connection that waits until its commits are on disk: WAL mode, synchronous=FULL. Its
/// statements may call row_checksum(), see sqlite.cpp.
class Database {
 public:
  /// Fails: data_loss (damaged), resource_exhausted (disk full), as SQLite says.
  static Result<Database> open(const std::filesystem::path& path);
  /// Opens a file that is there, and changes nothing of it. Fails: likewise.
  static Result<Database> open_as_it_is(const std::filesystem::path& path);

  Status execute(const char* sql);

  /// Returns whether the last call failed at a file otherwise than in a write.
  bool failed_beyond_write() const;

  Result<Statement> prepare(const char* sql);

 private:
  static Result<Database> open_with(const std::filesystem::path& path, int flags);
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
};

/// Runs BEGIN now, and ROLLBACK at the end of the scope unless commit() was called.
class Transaction {
 public:
  static Result<Transaction> begin(Database& database);
  Transaction(Transaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
  ~Transaction();

  /// A failed sync leaves the outcome unknown: the log may hold the whole transaction, and SQLite
  /// finds it there after a crash. All other I/O errors but one count as unknown too. A failed
  /// write is a refusal: the log's last frame is not whole then, and its checksum says so.
  WriteOutcome commit();

 private:
  explicit Transaction(Database& database) : database_(&database) {}
  Database* database_;
};

}  // namespace burnish
