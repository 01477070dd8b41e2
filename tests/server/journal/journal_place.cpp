#include "tests/server/journal/journal_place.h"

#include "server/journal/postgres_journal.h"
#include "server/journal/sqlite_journal.h"
#include "tests/server/postgres/postgres_cluster.h"

namespace burnish {

static std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

JournalPlace::JournalPlace(JournalKind kind) : kind_(kind) {
  if (kind == JournalKind::kPostgres) uri_ = PostgresCluster::shared().make_database();
}

std::unique_ptr<Journal> JournalPlace::open() const {
  if (kind_ == JournalKind::kSqlite)
    return std::move(SqliteJournal::open(folder_ / "j.sqlite")).value();
  return std::move(PostgresJournal::open(PgAddress::parse(uri_).value(), folder_ / "paint.sqlite"))
      .value();
}

Status JournalPlace::change(const std::string& sql) const {
  if (kind_ == JournalKind::kSqlite) {
    ASSIGN_OR_RETURN(Database database, Database::open(folder_ / "j.sqlite"));
    RETURN_IF_ERROR(database.execute("PRAGMA foreign_keys=OFF"));
    return database.execute(sql.c_str());
  }
  ASSIGN_OR_RETURN(PgConnection database,
                   PgConnection::open(PgAddress::parse(uri_).value(), {}, "test"));
  return database.script(
      replaced(replaced(sql, "BLOB", "bytea"), "x''", "CAST('' AS bytea)").c_str());
}

}  // namespace burnish
