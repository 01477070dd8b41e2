#include "server/journal/paint_cache.h"

#include <spdlog/spdlog.h>

#include "server/journal/sqlite_rows.h"

namespace burnish {

static Result<Database> open_table(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(Database database, Database::open(path));
  // A lost commit costs a replay.
  RETURN_IF_ERROR(database.execute("PRAGMA synchronous=OFF"));
  RETURN_IF_ERROR(
      database.execute("CREATE TABLE IF NOT EXISTS paint ("
                       "sequence INTEGER PRIMARY KEY AUTOINCREMENT, session_id BLOB NOT NULL,"
                       "series INTEGER NOT NULL, strokes INTEGER NOT NULL, bytes BLOB NOT NULL,"
                       "UNIQUE (session_id, series))"));
  return database;
}

Result<std::unique_ptr<PaintCache>> PaintCache::open(const std::filesystem::path& path) {
  auto database = open_table(path);
  if (!database.is_ok() && database.status().code() == StatusCode::kDataLoss) {
    spdlog::warn("{}: {}; it begins anew", path.string(), database.status().message());
    for (const char* end : {"", "-wal", "-shm"}) {
      std::error_code ignored;
      std::filesystem::remove(path.string() + end, ignored);
    }
    database = open_table(path);
  }
  RETURN_IF_ERROR(database.status().with_context(path.string()));
  return std::unique_ptr<PaintCache>(new PaintCache(std::move(*database)));
}

static void note_failure(const WriteOutcome& outcome) {
  if (!outcome.is_on_disk()) spdlog::warn("cache of paint: {}", outcome.status().message());
}

void PaintCache::copy(const std::string& from, const std::string& to) {
  commit_.post_background(
      [from, to](Database& database) {
        return run(database,
                   "INSERT OR IGNORE INTO paint (session_id, series, strokes, bytes)"
                   " SELECT ?, series, strokes, bytes FROM paint WHERE session_id = ?"
                   " ORDER BY sequence",
                   to, from);
      },
      note_failure);
}

void PaintCache::forget(const std::string& session_id) {
  commit_.post_background(
      [session_id](Database& database) {
        return run(database, "DELETE FROM paint WHERE session_id = ?", session_id);
      },
      note_failure);
}

}  // namespace burnish
