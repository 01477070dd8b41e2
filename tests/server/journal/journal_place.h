#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "server/journal/journal.h"
#include "tests/common/temporary_folder.h"

namespace burnish {

enum class JournalKind { kSqlite, kPostgres };
inline constexpr JournalKind kJournalKinds[] = {JournalKind::kSqlite, JournalKind::kPostgres};

inline std::string name_of_kind(const testing::TestParamInfo<JournalKind>& kind) {
  return kind.param == JournalKind::kSqlite ? "Sqlite" : "Postgres";
}

/// The place of a test's journal: a file, or a database of its own.
class JournalPlace {
 public:
  explicit JournalPlace(JournalKind kind);

  /// Opens the journal; a new one at the first time.
  std::unique_ptr<Journal> open() const;

  /// Runs SQL of SQLite on the journal's tables while it is closed. BLOB and x'' become what
  /// PostgreSQL calls them.
  Status change(const std::string& sql) const;

 private:
  const JournalKind kind_;
  const TemporaryFolder folder_;
  std::string uri_;
};

}  // namespace burnish
